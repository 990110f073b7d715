# SPDX-License-Identifier: BSD-3-Clause
"""Sections of the report, as report.json for mono-slam-report and as Markdown for libs/docs."""
import json
from dataclasses import dataclass

import pandas as pd

from batches import write_aside

TITLE = "Multiple hypotheses data association, reproduced"
INTRO = """Soto-Alvarez and Honkamaa (2013) propagate several associations from frame to frame (MHDA) and compare seven
methods on the first 200 frames of a rendered sequence, one run each. That sequence is not to be had; ours is an office
table of our own: keyboard and telephone with equal keys, several depth planes, short and long occlusions, 640x480, 30 Hz,
exact pose and depth. So the digits cannot agree, and what is tested is the order and the claims.

Everything is run twice: with *the paper's settings* (`config/soto2013.ini`: undelayed inverse depth, whole pixels of
1 px noise, one search and one linearisation a frame, no re-estimation of the first seconds) and with *our defaults*
(`config/default.ini`), the latter with fewer seeds (tables say how many runs). The strategy is changed and nothing else;
detection and noise share their seeds. A dark rectangle of known size, in view in the first frame, gives metric scale.

**What is measured**, since the paper defines none of it. Position and orientation: mean over the frames of the distance
and of the angle to the true pose, in the world that the target defines, without alignment. The target's pose in the first
frame has an error of its own that no association can mend; so position after SE3 stands beside. Landmarks: distance to
the true surface point that the pixel of the landmark's first frame shows, over all that are alive at the end and have a
finite depth; mean (as the paper) and median. Time: mean CPU time of a frame without decoding, all threads,
from the second frame on. A run that loses track or fails counts like any other. The images are the same for all seeds: what
the seeds vary is where corners are looked for and what a method draws."""


@dataclass
class Section:
    title: str
    text: str
    table: str | None = None  # name of tables/NAME.csv
    figure: str | None = None  # name of figures/NAME


class Document:
    def __init__(self, output):
        self.output = output
        self.sections = []
        for folder in ("tables", "figures"):
            (output / folder).mkdir(exist_ok=True)

    def add(self, title, text, table=None, name=None, figure=None):
        """\\param table  a DataFrame, written to tables/NAME.csv"""
        if table is not None:
            write_aside(self.output / "tables" / f"{name}.csv", table.to_csv(index=False))
        self.sections.append(Section(title, text, name if table is not None else None, figure))

    def write(self, facts):
        """report.json and soto2013.md; \\param facts  a paragraph about this very run"""
        sections = []
        for s in self.sections:
            entry = {"title": s.title, "text": s.text}
            if s.table:
                entry["table"] = f"tables/{s.table}.csv"
            if s.figure:
                entry["figure"] = f"figures/{s.figure}"
            sections.append(entry)
        report = {"title": TITLE, "intro": f"{INTRO}\n\n{facts}", "sections": sections}
        write_aside(self.output / "report.json", json.dumps(report, indent=1) + "\n")
        write_aside(self.output / "soto2013.md", self.markdown(facts))

    def markdown(self, facts):
        parts = [f"# {TITLE}", "Written by `apps/experiments/soto2013/run.sh`, which also writes the figures and "
                 "`report.html` to its results folder.", INTRO, facts]
        for s in self.sections:
            parts += [f"## {s.title}", s.text]
            if s.table:
                parts.append(markdown_table(pd.read_csv(self.output / "tables" / f"{s.table}.csv", dtype=str,
                                                        keep_default_na=False)))
        return "\n\n".join(parts) + "\n"


def markdown_table(table):
    head = ["| " + " | ".join(table.columns) + " |", "|---" + "|--:" * (len(table.columns) - 1) + "|"]
    if "verdict" in table:
        head[1] = "|---" * len(table.columns) + "|"
    return "\n".join(head + ["| " + " | ".join(row) + " |" for row in table.itertuples(index=False)])
