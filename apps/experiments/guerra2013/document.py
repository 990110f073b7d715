# SPDX-License-Identifier: BSD-3-Clause
"""report.json for mono-slam-report, and the same sections as Markdown for the documentation."""
import json
from dataclasses import dataclass, field

from programs import write_text

TITLE = "Guerra et al. 2013: HOHCT and JCBB in monocular SLAM with delayed inverse depth"
INTRO = """Guerra, Munguia, Bolea and Grau, "Validation of Data Association for Monocular SLAM" (2013), compare two
tests of a frame's pairs: JCBB, and their HOHCT, which rejects as few pairs as possible. Their tables and
figures are made again here on rendered laboratory sequences of the same size and rate (424x240, 15 frames a
second), since their videos are not available: what can be compared is ratios and shapes, not digits.

First comes exactly their pair: HOHCT as printed in their Algorithm 1 with full inversions, and JCBB with
incremental evaluation and without a bound. Beside it stand our HOHCT (branch and bound), JCBB with its
textbook bound, and MRPT's. A *search* is a frame whose full set of pairs is not jointly compatible, as in
the paper's Table 1. The problems of all searches are written to files by the run with the printed HOHCT, and
every method solves the same files. Limits are chi2(2 pairs, 0.95); the paper's text has one degree of freedom
a pair, with which right sets would fail in most frames. Configuration: `config/guerra2013.ini`, where nothing
else is said; its 25 features give about as many pairs in a search as the paper has. Times are CPU times of one
thread. n is the number of pairs of a search, r of those that HOHCT rejects."""


@dataclass
class Section:
    title: str
    text: str = ""
    tables: list = field(default_factory=list)
    figure: str | None = None

    def entries(self):
        """One for each table, because mono-slam-report takes one a section."""
        first = {"title": self.title, "text": self.text}
        if self.figure:
            first["figure"] = f"figures/{self.figure}"
        entries = [first]
        for table in self.tables:
            target = first if "table" not in first and len(self.tables) == 1 else None
            if target is None:
                target = {"title": table.title, "text": table.note}
                entries.append(target)
            target["table"] = f"tables/{table.name}.csv"
        return entries

    def markdown(self):
        lines = [f"## {self.title}\n", self.text + "\n" if self.text else ""]
        for table in self.tables:
            heading = f"### {table.title}\n\n" if len(self.tables) > 1 else ""
            lines.append(heading + (table.note + "\n\n" if table.note else "") + table.markdown())
        return "\n".join(line for line in lines if line)


def write(output, sections, how):
    """how: the command and what it ran, which stands before all sections."""
    intro = f"{INTRO}\n\n{how}"
    for section in sections:
        for table in section.tables:
            table.write(output)
    report = {"title": TITLE, "intro": intro,
              "sections": [entry for section in sections for entry in section.entries()]}
    write_text(output / "report.json", json.dumps(report, indent=1) + "\n")
    text = f"# {TITLE}\n\n{intro}\n\n" + "\n".join(section.markdown() for section in sections)
    write_text(output / "guerra2013.md", text)
