# SPDX-License-Identifier: BSD-3-Clause
"""Errors of position and orientation over time, all seeds as a band."""
import math

import numpy as np
import pandas as pd

from . import panels
from .bands import band
from .context import Context
from .figures import Figure
from .job import Job
from .page import Section
from .results import Cell

COLUMNS = ["position [mm]", "orientation [deg]"]


def section(context: Context) -> Section:
    out = Section("Errors over time")
    out.say("Errors of the causal pose of every frame: of its position after the alignment with the truth, of "
            "its orientation after the rotation that fits all orientations best. Line: median over the seeds. Dark band: quartiles. Light band: best and worst. Panels of a column share "
            "their axes; the axis is logarithmic where strategies differ by more than a factor of "
            f"{panels.LOG_FROM}.")
    context.add_figures(out, lambda cell: draw(context, cell), "No run has ground truth.")
    return out


def errors_of(job: Job) -> list[tuple[np.ndarray, np.ndarray]] | None:
    """Time since the first frame with position error [mm] and with orientation error [deg]."""
    if job.frames is None or job.track is None:
        return None
    t_s = job.track.t_s - job.start_s
    return [(t_s, 1e3 * job.track.position_error_m), (t_s, job.track.rotation_error_deg)]


def draw(context: Context, cell: Cell) -> Figure | None:
    strategies = context.results.strategies_of(cell)
    runs = {name: [e for e in map(errors_of, context.results.done(cell, name)) if e] for name in strategies}
    if not any(runs.values()):
        return None
    figure, axes = panels.grid(strategies, COLUMNS, "time since the first frame [s]")
    bands = {name: [band(run[i] for run in runs[name]) for i in (0, 1)] if runs[name] else [] for name in strategies}
    for name in strategies:
        for axis, table in zip(axes[name], bands[name]):
            panels.draw_band(axis, table, context.look.colour(name))
        if not bands[name]:
            panels.say_no_data(axes[name][0])
    for i in (0, 1):
        panels.log_if_wide([row[i] for row in axes.values()], [b[i]["median"] for b in bands.values() if b])
    return context.figures.save(figure, f"errors_{cell.name}", caption(cell, runs, bands))


def caption(cell: Cell, runs: dict, bands: dict[str, list[pd.DataFrame]]) -> str:
    at_end = {name: float(b[0]["median"].tail(10).median()) for name, b in bands.items() if b}
    best = min(at_end, key=lambda name: at_end[name] if math.isfinite(at_end[name]) else math.inf)
    counts = ", ".join(f"{name} {len(runs[name])}" for name in runs)
    return (f"{cell.title}: seeds drawn: {counts}. At the end the median "
            f"position error is smallest with {best}, {at_end[best]:.3g} mm.")
