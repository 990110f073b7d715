# SPDX-License-Identifier: BSD-3-Clause
"""NEES of the pose and NIS of the accepted pairs over time, with their chi-square bounds."""
import numpy as np
import pandas as pd
from scipy.stats import chi2

from . import panels, style
from .bands import band
from .context import Context
from .figures import Figure
from .job import Job
from .page import Section
from .results import Cell

POSE = 6  # numbers of a pose
INSIDE = (0.025, 0.975)
COLUMNS = ["NEES / 6 [1]", "NIS / 2 pairs [1]"]


def section(context: Context) -> Section:
    out = Section("Consistency")
    out.say("NEES: squared error of the pose in units of the covariance that the filter gives it, divided by its 6 "
            "numbers. NIS: joint squared Mahalanobis distance of the accepted pairs, divided by 2 for each pair. Both "
            "are 1 on average if the covariances are right; above, the filter is too sure of itself, below, it is "
            "too careful. The grey region holds 95 % of the values of a consistent filter in one run (for NIS with "
            "the median number of pairs). NEES is that of `errors.csv`, whose alignment the batch names; NIS is of the strategies that report a joint distance.")
    context.add_figures(out, lambda cell: draw(context, cell),
                        "No run has a joint distance, nor a NEES (errors.csv, which mono-slam-batch writes).")
    return out


def nis_of(job: Job) -> pd.DataFrame | None:
    """Columns t_s, ratio, inside, dof of the frames with a joint distance."""
    table = job.frames
    if table is None or "joint_d2" not in table:
        return None
    dof = 2 * (table["pairs"] - table["rejected"])
    kept = (table["joint_d2"] > 0) & (dof > 0)
    if not kept.any():
        return None
    return judged(table["t_s"][kept] - job.start_s, table["joint_d2"][kept], dof[kept])


def nees_of(job: Job) -> pd.DataFrame | None:
    """From the second pose on: the first is exact by definition where it is what aligns."""
    table = job.errors
    if table is None or job.frames is None or "nees" not in table:
        return None
    table = table.iloc[1:].dropna(subset=["nees"])
    if table.empty:
        return None
    return judged(table["t_s"] - job.start_s, table["nees"], pd.Series(POSE, index=table.index))


def judged(t_s: pd.Series, squared: pd.Series, dof: pd.Series) -> pd.DataFrame:
    low, high = (chi2.ppf(share, dof) for share in INSIDE)
    return pd.DataFrame({"t_s": t_s, "ratio": squared / dof, "inside": squared.between(low, high), "dof": dof})


def draw(context: Context, cell: Cell) -> Figure | None:
    strategies = context.results.strategies_of(cell)
    found = {name: [[t for t in map(read, context.results.done(cell, name)) if t is not None]
                    for read in (nees_of, nis_of)] for name in strategies}
    if not any(tables for pair in found.values() for tables in pair):
        return None
    figure, axes = panels.grid(strategies, COLUMNS, "time since the first frame [s]")
    lines = []
    for name in strategies:
        for axis, tables, what in zip(axes[name], found[name], ("NEES", "NIS")):
            axis.set_yscale("log")
            if tables:
                lines.append(f"{name} {what} {draw_panel(axis, tables, context.look.colour(name)):.0%}")
            else:
                panels.say_no_data(axis, f"no {what}")
    caption = (f"{cell.title}: median, quartiles and extremes over the seeds; the line at 1 is the expected value. "
               f"Frames inside the 95 % bounds: {', '.join(lines)}.")
    return context.figures.save(figure, f"consistency_{cell.name}", caption)


def draw_panel(axis, tables: list[pd.DataFrame], colour: str) -> float:
    """\\return the share of frames inside their bounds"""
    dof = float(np.median(pd.concat(tables)["dof"]))
    low, high = (chi2.ppf(share, dof) / dof for share in INSIDE)
    axis.axhspan(low, high, color=style.MUTED, alpha=0.2, lw=0)
    axis.axhline(1, color=style.MUTED, lw=0.9)
    panels.draw_band(axis, band((t["t_s"], t["ratio"]) for t in tables), colour)
    return float(pd.concat(tables)["inside"].mean())
