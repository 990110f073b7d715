# SPDX-License-Identifier: BSD-3-Clause
"""results.csv of mono-slam-batch: which runs there are, in the order of the batch."""
import math
from dataclasses import dataclass, field
from pathlib import Path

import pandas as pd

from .errors import ReportError
from .job import Job

NEEDED = ("sequence", "strategy", "variant", "seed", "status", "folder")
STATUSES = ("done", "failed", "pending")


@dataclass(frozen=True)
class Cell:
    """All strategies and seeds of one sequence under one variant are compared with each other."""

    sequence: str
    variant: str

    @property
    def title(self) -> str:
        return self.sequence if self.variant == "default" else f"{self.sequence}, {self.variant}"

    @property
    def name(self) -> str:
        return f"{self.sequence}_{self.variant}"


@dataclass
class Results:
    folder: Path
    rows: pd.DataFrame
    jobs: list[Job] = field(default_factory=list)

    @property
    def cells(self) -> list[Cell]:
        return list(dict.fromkeys(Cell(job.sequence, job.variant) for job in self.jobs))

    @property
    def strategies(self) -> list[str]:
        return list(dict.fromkeys(job.strategy for job in self.jobs))

    def strategies_of(self, cell: Cell) -> list[str]:
        return list(dict.fromkeys(job.strategy for job in self._of(cell)))

    def jobs_of(self, cell: Cell, strategy: str | None = None) -> list[Job]:
        return [job for job in self._of(cell) if strategy in (None, job.strategy)]

    def done(self, cell: Cell, strategy: str) -> list[Job]:
        return [job for job in self.jobs_of(cell, strategy) if job.status == "done"]

    def count(self, status: str) -> int:
        return sum(job.status == status for job in self.jobs)

    @property
    def notes(self) -> list[str]:
        """What could not be read, as far as something has asked for it."""
        return [note for job in self.jobs for note in job.notes]

    def _of(self, cell: Cell) -> list[Job]:
        return [job for job in self.jobs if (job.sequence, job.variant) == (cell.sequence, cell.variant)]


def read_results(folder: Path) -> Results:
    file = folder / "results.csv"
    try:
        rows = pd.read_csv(file, dtype={name: str for name in NEEDED if name != "seed"}, keep_default_na=False,
                           na_values={"seed": [""]}, low_memory=False)
    except FileNotFoundError:
        raise ReportError(f"{file}: no such file; mono-slam-batch BATCH.ini --collect writes it") from None
    except (ValueError, OSError) as error:
        raise ReportError(f"{file}: {str(error).splitlines()[0]}") from None
    missing = [name for name in NEEDED if name not in rows]
    if missing:
        raise ReportError(f"{file}: column '{missing[0]}' is missing; is it of mono-slam-batch?")
    jobs = [job_of(folder, file, number, row) for number, row in enumerate(rows.to_dict("records"), 2)]
    if not jobs:
        raise ReportError(f"{file}: no runs in it")
    return Results(folder, rows, jobs)


def job_of(folder: Path, file: Path, line: int, row: dict) -> Job:
    if row["status"] not in STATUSES:
        raise ReportError(f"{file}: line {line}: status '{row['status']}' is none of {', '.join(STATUSES)}")
    try:
        seed = int(row["seed"])
    except ValueError:
        raise ReportError(f"{file}: line {line}: seed '{row['seed']}' is no number") from None
    figures = {name: number(value) for name, value in row.items() if name not in NEEDED}
    return Job(sequence=row["sequence"], strategy=row["strategy"], variant=row["variant"], seed=seed,
               status=row["status"], folder=folder / row["folder"], figures=figures,
               error=str(row.get("error", "")))


def number(value) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        return math.nan
