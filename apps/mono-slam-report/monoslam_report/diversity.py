# SPDX-License-Identifier: BSD-3-Clause
"""How far the beliefs of a strategy that carries several of them differ."""
import numpy as np

from . import panels, style
from .bands import band
from .context import Context
from .figures import Figure
from .job import Job
from .page import Section
from .results import Cell

COLUMNS = ["effective_beliefs", "belief_distance", "ancestor_age_frames"]
LABELS = ["effective [beliefs]", "spread [mm]", "ancestor [frames]"]
FACTORS = [1, 1e3, 1]


def section(context: Context) -> Section:
    out = Section("Diversity of particles")
    out.say("*Effective beliefs*: 1 / Σ w², the number of beliefs if all weights were equal; the grey line is how many "
            "are carried. *Spread*: the largest distance between two of their positions. *Ancestor*: how many frames ago all "
            "beliefs were one; where it stays small, no hypothesis outlives a few frames.")
    context.add_figures(out, lambda cell: draw(context, cell), "No strategy carries several beliefs.")
    return out


def diverse(job: Job) -> bool:
    table = job.frames
    return table is not None and {"beliefs", *COLUMNS} <= set(table) and table["beliefs"].max() > 1


def draw(context: Context, cell: Cell) -> Figure | None:
    runs = {name: [job for job in context.results.done(cell, name) if diverse(job)]
            for name in context.results.strategies_of(cell)}
    runs = {name: jobs for name, jobs in runs.items() if jobs}
    if not runs:
        return None
    figure, axes = panels.grid(list(runs), LABELS, "time since the first frame [s]")
    facts = []
    for name, jobs in runs.items():
        for axis, column, factor in zip(axes[name], COLUMNS, FACTORS):
            table = band((job.frames["t_s"] - job.start_s, job.frames[column]) for job in jobs)
            panels.draw_band(axis, table, context.look.colour(name), factor)
            axis.set_ylim(bottom=0)
        carried = band((job.frames["t_s"] - job.start_s, job.frames["beliefs"]) for job in jobs)
        axes[name][0].plot(carried["at"], carried["median"], color=style.MUTED, lw=1)
        effective, age = (np.concatenate([job.frames[c] for job in jobs]) for c in (COLUMNS[0], COLUMNS[2]))
        facts.append(f"{name}: {np.mean(effective):.2f} effective beliefs on average, common ancestor "
                     f"{np.median(age):.0f} frames ago (median), at most {np.max(age):.0f}")
    return context.figures.save(figure, f"diversity_{cell.name}", f"{cell.title}: median, quartiles and extremes over "
                                f"the seeds. {'; '.join(facts)}.")
