# SPDX-License-Identifier: BSD-3-Clause
"""Batches for mono-slam-batch: written as ini, run, their results.csv read."""
import dataclasses
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pandas as pd

ROOT = Path(__file__).resolve().parents[3]
PROGRAMS = Path(os.environ["MONOSLAM_PROGRAMS"])
CONFIGURATIONS = {"paper": ROOT / "config" / "soto2013.ini", "ours": ROOT / "config" / "default.ini"}
OURS = "-ours"  # ends the name of a batch whose rows belong to the batch named before it


@dataclasses.dataclass
class Sequence:
    """One recording as a batch takes it."""
    name: str
    rawlog: Path
    truth: Path | None  # None: out and back
    settings: dict
    depth: Path | None = None
    frames: int = 0  # 0: all
    length: int = 0  # all frames, where it is known


@dataclasses.dataclass
class Batch:
    """Every sequence under every configuration, with every strategy, variant and seed."""
    name: str
    sequences: list
    configurations: list
    strategies: list
    variants: dict  # name: (settings, strategy that it is for or None)
    seeds: int
    jobs: int | None = None  # None: as many as the call says

    def cells(self):
        """(strategy, variant, sequence, configuration) of all runs, which differ in their seeds beside."""
        return [(strategy, variant, sequence, configuration)
                for variant, (_, only) in self.variants.items() for strategy in ([only] if only else self.strategies)
                for sequence in self.sequences for configuration in self.configurations]

    @property
    def runs(self):
        return len(self.cells()) * self.seeds

    def ini(self):
        lines = ["[batch]", f"output = {self.name}", f"strategies = {' '.join(self.strategies)}",
                 f"seeds = 1-{self.seeds}"]
        for sequence in self.sequences:
            for configuration in self.configurations:
                lines += section_of(sequence, configuration)
        for name, (settings, strategy) in self.variants.items():
            lines += [f"[variant.{name}]"] + ([f"strategies = {strategy}"] if strategy else [])
            lines += [f"{key} = {value}" for key, value in settings.items()]
        return "\n".join(lines) + "\n"


def by_configuration(batch, own_seeds):
    """The batch in two: with our defaults fewer seeds do."""
    return [dataclasses.replace(batch, configurations=["paper"]),
            dataclasses.replace(batch, name=batch.name + OURS, configurations=["ours"],
                                seeds=min(batch.seeds, own_seeds))]


def section_of(sequence, configuration):
    settings = {**sequence.settings, "rawlog.frame_count": sequence.frames}
    return [f"[sequence.{sequence.name}.{configuration}]", f"rawlog = {sequence.rawlog}",
            f"config = {CONFIGURATIONS[configuration]}",
            f"truth = {sequence.truth}" if sequence.truth else "out_and_back = true",
            *([f"depth = {sequence.depth}"] if sequence.depth else []),
            *(f"{key} = {value}" for key, value in settings.items())]


def prepare(output):
    """The results folder: absent, empty, or one of ours."""
    mark = output / "batches"
    if output.is_dir() and any(output.iterdir()) and not mark.is_dir():
        sys.exit(f"soto2013: {output}: the output folder is not empty and not of this experiment")
    mark.mkdir(parents=True, exist_ok=True)


def run(batch, output, jobs):
    """Runs what is missing; a row a run. A run that fails is a row too, as it is of the method."""
    ini = output / "batches" / f"{batch.name}.ini"
    write_aside(ini, batch.ini())
    print(f"== {batch.name}: {batch.runs} runs", flush=True)
    with (ini.with_suffix(".log")).open("w") as log:  # a line a run; on a terminal progress instead
        done = subprocess.run([PROGRAMS / "mono-slam-batch", ini, "--output", output, "--force", "--jobs",
                               str(batch.jobs or jobs)], stdout=log, stderr=None if sys.stderr.isatty() else log)
    table = output / "batches" / f"{batch.name}.csv"
    results = output / "results.csv"
    if done.returncode not in (0, 1) or not results.is_file() or ini.stat().st_mtime > results.stat().st_mtime:
        sys.exit(f"soto2013: the batch {ini} did not run; see {ini.with_suffix('.log')}")
    shutil.copyfile(results, table)
    rows = pd.read_csv(table).copy()  # in one block, to which columns are added
    rows.insert(0, "batch", batch.name.removesuffix(OURS))
    if (rows.status == "pending").any():
        sys.exit(f"soto2013: the batch {ini} was interrupted; call again to go on")
    return split_names(rows)


def split_names(rows):
    """"office_200.paper" says sequence and configuration."""
    parts = rows.sequence.str.rsplit(".", n=1)
    rows.insert(2, "configuration", parts.str[1])
    rows["sequence"] = parts.str[0]
    return rows


def write_aside(path, text):
    part = path.with_name(path.name + ".part")
    part.write_text(text)
    os.replace(part, path)
