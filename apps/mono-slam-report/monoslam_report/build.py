# SPDX-License-Identifier: BSD-3-Clause
"""All sections of a report in their order, and report.html."""
import os
from dataclasses import dataclass
from pathlib import Path

from . import (consistency, cost, diversity, frames, maps, over_time, page, rejections, style, summary,
               trajectories)
from .context import Context
from .errors import ReportError
from .experiment import Experiment, read_experiment
from .figures import FigureFolder
from .page import Section
from .rerun import Rerun
from .results import Results, read_results

OUR_MARK = '<meta name="generator" content="mono-slam-report">'
STANDARD = [summary, trajectories, maps, over_time, cost, consistency, rejections, diversity]
MOST_NOTES = 30


@dataclass(frozen=True)
class Options:
    reference: str | None = None
    cells: int = 6
    paths: int = 3
    pictures: Path | None = None  # a batch, of which frames are drawn
    programs: Path = Path()
    force: bool = False


def build(folder: Path, options: Options) -> tuple[Path, list[str]]:
    """\\return the report, and what could not be read"""
    if not folder.is_dir():
        raise ReportError(f"{folder}: no such folder")
    page_file = folder / "report.html"
    refuse_foreign(page_file, options.force)
    style.apply()
    experiment = read_experiment(folder)
    if experiment and not (folder / "results.csv").exists():
        write(page_file, page.render(experiment.title, experiment.intro, "", experiment.sections))
        return page_file, []
    results = read_results(folder)
    sections = standard_sections(results, options)
    experiment = experiment or Experiment(f"Batch {folder.resolve().name}")
    write(page_file, page.render(experiment.title or folder.resolve().name, experiment.intro, facts_of(results),
                                 [*experiment.sections, *sections]))
    return page_file, results.notes


def refuse_foreign(file: Path, force: bool) -> None:
    if file.exists() and not force and OUR_MARK not in file.read_text(encoding="utf-8", errors="replace"):
        raise ReportError(f"{file}: exists and is not of mono-slam-report; --force replaces it")


def standard_sections(results: Results, options: Options) -> list[Section]:
    reference = options.reference or results.strategies[0]
    if reference not in results.strategies:
        raise ReportError(f"--reference: no strategy '{reference}' in the results, which have "
                          f"{', '.join(results.strategies)}")
    rerun = Rerun(options.pictures, results.folder, options.programs) if options.pictures else None
    context = Context(results, FigureFolder(results.folder), style.Look(results.strategies), reference,
                      options.cells, options.paths)
    sections = [module.section(context) for module in STANDARD]
    return [*sections, frames.section(context, rerun), about(results)]


def about(results: Results) -> Section:
    out = Section("About these runs")
    out.say(f"{facts_of(results)}. Figures are in `figures` beside this page, as SVG and PNG (`batch_…`).")
    failed = [job for job in results.jobs if job.status == "failed"]
    lines = [f"- failed: {job.sequence}, {job.strategy}, {job.variant}, seed {job.seed}: `{job.error or 'no message'}`"
             for job in failed] + [f"- could not be read: `{note}`" for note in results.notes]
    if lines:
        more = [f"- and {len(lines) - MOST_NOTES} more"] if len(lines) > MOST_NOTES else []
        out.say("\n".join([*lines[:MOST_NOTES], *more]))
    else:
        out.say("No run failed, and all files could be read.")
    return out


def facts_of(results: Results) -> str:
    def counted(number: int, one: str) -> str:
        return f"{number} {one}" if number == 1 else f"{number} {one[:-1]}ies" if one[-1] == "y" else f"{number} {one}s"

    states = ", ".join(f"{results.count(s)} {s}" for s in ("done", "failed", "pending") if results.count(s))
    sequences = len({job.sequence for job in results.jobs})
    variants = len({job.variant for job in results.jobs})
    seeds = len({job.seed for job in results.jobs})
    return (f"{counted(sequences, 'sequence')}, {counted(len(results.strategies), 'strategy')}, "
            f"{counted(variants, 'variant')}, {counted(seeds, 'seed')}; {len(results.jobs)} runs: {states}")


def write(file: Path, text: str) -> None:
    part = file.with_suffix(".html.part")
    part.write_text(text, encoding="utf-8")
    os.replace(part, file)
