# SPDX-License-Identifier: BSD-3-Clause
"""Results over seeds: a table of all strategies, how each seed did, and paired sign tests."""
import math
from dataclasses import dataclass

from markupsafe import Markup

from .context import Context
from .figures import Figure
from .job import Job
from .page import Section, Table, short
from .results import Cell
from .seed_dots import draw
from .seeds import SignTest, Summary, sign_test, summary


NONE = "–"


@dataclass(frozen=True)
class Measure:
    """A column of results.csv; {fit} is SE3 where a target gives scale, else Sim3."""

    column: str
    label: str
    is_error: bool = True  # a run that failed, or has none where others have one, lost
    factor: float = 1.0

    def of(self, job: Job) -> float:
        return self.factor * job.figure(self.column.format(fit=fit_of(job)))


def fit_of(job: Job) -> str:
    return "SE3" if job.metric else "Sim3"


POSITION = Measure("{fit}_ate_rmse_mm", "position error, rms [mm]")
GAP = Measure("gap_pct", "closing gap [% of path]")
MEASURES = [POSITION, Measure("rotation_own_rms_deg", "rotation error, rms [deg]"), GAP,
            Measure("{fit}_landmark_mean_m", "landmark error, mean [mm]", factor=1e3),
            Measure("{fit}_landmark_median_m", "landmark error, median [mm]", factor=1e3),
            Measure("frames_lost", "frames lost", is_error=False),
            Measure("time_median_ms", "time a frame, median [ms]", is_error=False),
            Measure("time_p995_ms", "time a frame, 99.5 % [ms]", is_error=False)]


def value(measure: Measure, job: Job, known: bool) -> float:
    """Infinite for a run that lost; \\p known: other runs of the cell have a figure."""
    found = measure.of(job)
    if job.status == "done" and not math.isnan(found):
        return found
    return math.inf if measure.is_error and known and job.status != "pending" else math.nan


def values(context: Context, cell: Cell, strategy: str, measure: Measure) -> dict[int, float]:
    """Seed: value."""
    known = any(not math.isnan(measure.of(job)) for job in context.results.jobs_of(cell))
    return {job.seed: value(measure, job, known) for job in context.results.jobs_of(cell, strategy)}


def dots(context: Context, cell: Cell, measure: Measure) -> Figure | None:
    seeds = {name: values(context, cell, name, measure) for name in context.results.strategies_of(cell)}
    if all(math.isnan(v) for found in seeds.values() for v in found.values()):
        return None
    return draw(context, cell, seeds, measure.label)


def measures_of(context: Context) -> list[Measure]:
    return [m for m in MEASURES if any(not math.isnan(m.of(job)) for job in context.results.jobs)]


def section(context: Context) -> Section:
    out = Section("Results over seeds")
    measures = measures_of(context)
    out.say("Median over the seeds, below it the quartiles and the worst. A run that failed counts as infinitely "
            "wrong (∞). Position errors are after alignment with the truth: SE3 where a target gives metric "
            "scale, Sim3 (scale fitted too) where none does.")
    out.blocks.append(table_of(context, measures))
    shown = POSITION if POSITION in measures else GAP
    if shown in measures:
        context.add_figures(out, lambda cell: dots(context, cell, shown), "No run has an error.")
    if len(context.results.strategies) > 1:
        out.say(f"### Against {context.reference}")
        out.say(f"Pairs of runs with the same seed: how often the strategy is better – worse than {context.reference} "
                "(and equal, if ever), and p of the two-sided sign test. p is not corrected for the number of tests; "
                "bold where it is below 0.05.")
        tests = tests_of(context, [m for m in measures if m.column != "frames_lost"])
        if tests.rows:
            out.blocks.append(tests)
        else:
            out.say("*No two runs with the same seed have ended.*")
    return out


def table_of(context: Context, measures: list[Measure]) -> Table:
    rows = []
    for cell in context.results.cells:
        for name in context.results.strategies_of(cell):
            cells = [entry(summary(values(context, cell, name, m).values())) for m in measures]
            rows.append([cell.title, name, runs_of(context.results.jobs_of(cell, name)), *cells])
    return Table(["sequence", "strategy", "runs", *(m.label for m in measures)], rows)


def runs_of(jobs: list[Job]) -> str:
    counts = {status: sum(job.status == status for job in jobs) for status in ("done", "failed", "pending")}
    return ", ".join(f"{count} {status}" for status, count in counts.items() if count)


def entry(s: Summary) -> Markup | str:
    if not s.n:
        return NONE
    if s.n == 1 or s.iqr == 0 and s.worst == s.median:
        return short(s.median)
    quartiles = "–".join(short(quartile, digits=2) for quartile in s.quartiles)
    return Markup("{}<small>{}</small><small>worst {}</small>").format(short(s.median), quartiles, short(s.worst))


def tests_of(context: Context, measures: list[Measure]) -> Table:
    rows = []
    for cell in context.results.cells:
        for name in context.results.strategies_of(cell):
            if name == context.reference:
                continue
            outcomes = [outcome(tested(context, cell, name, m)) for m in measures]
            if any(found != NONE for found in outcomes):
                rows.append([cell.title, name, *outcomes])
    return Table(["sequence", "strategy", *(m.label for m in measures)], rows)


def tested(context: Context, cell: Cell, strategy: str, measure: Measure) -> SignTest:
    mine, other = (values(context, cell, name, measure) for name in (strategy, context.reference))
    seeds = sorted(mine.keys() & other.keys())
    return sign_test([mine[s] for s in seeds], [other[s] for s in seeds])


def outcome(test: SignTest) -> Markup | str:
    if not test.wins + test.losses + test.ties:
        return NONE
    ties = f" ({test.ties})" if test.ties else ""
    p = f"p = {test.p:.2g}" if test.p >= 1e-4 else "p < 0.0001"
    form = "{} – {}{}<small><b>{}</b></small>" if test.p < 0.05 else "{} – {}{}<small>{}</small>"
    return Markup(form).format(test.wins, test.losses, ties, p)
