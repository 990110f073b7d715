# SPDX-License-Identifier: BSD-3-Clause
"""Landmarks at the end of a run with the covariance the filter gives them."""
import math

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.collections import EllipseCollection
from scipy.stats import chi2

from . import style
from .context import Context
from .figures import Figure
from .job import Job
from .page import Section, short
from .results import Cell

ENTRIES = ["P_x_x", "P_x_y", "P_x_z", "P_y_y", "P_y_z", "P_z_z"]
RADIUS = math.sqrt(chi2.ppf(0.95, 2))
MAGNIFICATIONS = [1, 3, 10, 30, 100, 300]
WANTED = 0.05  # size of the median ellipse, as a share of the map's


def section(context: Context) -> Section:
    out = Section("Maps")
    out.say("The landmarks of one run a strategy (its first seed that ended), from above, moved as its path is. "
            "Ellipses are the 95 % regions that the filter believes in, magnified where they would be too small "
            "to see; the caption says by how much.")
    context.add_figures(out, lambda cell: draw(context, cell), "No run has a map.")
    return out


def landmarks(job: Job) -> tuple[np.ndarray, np.ndarray] | None:
    """Points and covariances [m] in the frame of the aligned path; rays of no certain depth left out."""
    table = job.map
    if table is None or not set(ENTRIES) <= set(table):
        return None
    table = table.dropna(subset=["x_m", "y_m", "z_m", *ENTRIES])
    if table.empty:
        return None
    points = table[["x_m", "y_m", "z_m"]].to_numpy(float)
    covariances = symmetric(table)
    if job.track is None or job.track.rotation is None:
        return points, covariances
    turn = job.track.scale * job.track.rotation
    return points @ turn.T + job.track.shift, turn @ covariances @ turn.T


def symmetric(table: pd.DataFrame) -> np.ndarray:
    upper = table[ENTRIES].to_numpy(float)
    return upper[:, [0, 1, 2, 1, 3, 4, 2, 4, 5]].reshape(-1, 3, 3)


def ellipses(covariances: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Full axes and angle [deg] of the 95 % regions in the plane of x and y."""
    values, vectors = np.linalg.eigh(covariances[:, :2, :2])
    axes = 2 * RADIUS * np.sqrt(np.maximum(values, 0))
    return axes[:, 1], axes[:, 0], np.degrees(np.arctan2(vectors[:, 1, 1], vectors[:, 0, 1]))


def magnification(maps: dict) -> int:
    """One for the whole figure, so that strategies can be compared."""
    middle = np.concatenate([points for points, _ in maps.values()])[:, :2]
    size = float((np.quantile(middle, 0.95, axis=0) - np.quantile(middle, 0.05, axis=0)).max())
    typical = float(np.median(np.concatenate([ellipses(P)[0] for _, P in maps.values()])))
    if typical <= 0:
        return 1
    return max((m for m in MAGNIFICATIONS if m * typical <= WANTED * size), default=1)


def draw(context: Context, cell: Cell) -> Figure | None:
    jobs = {name: context.results.done(cell, name) for name in context.results.strategies_of(cell)}
    found = {name: landmarks(row[0]) for name, row in jobs.items() if row}
    maps = {name: pair for name, pair in found.items() if pair is not None}
    if not maps:
        return None
    times = magnification(maps)
    low, high = limits([points for points, _ in maps.values()])
    columns = min(3 if high[0] - low[0] < 2 * (high[1] - low[1]) else 2, len(maps))
    rows = math.ceil(len(maps) / columns)
    panel_in = min((style.WIDTH_IN - 0.8) / columns * (high[1] - low[1]) / (high[0] - low[0]), 5.0)
    figure, axes = plt.subplots(rows, columns, squeeze=False, sharex=True, sharey=True,
                                figsize=(style.WIDTH_IN, 0.5 + (panel_in + 0.35) * rows))
    for i, axis in enumerate(axes.flat):
        axis.tick_params(labelbottom=i + columns >= len(maps))
        if i >= len(maps):
            axis.remove()
    for axis, (name, (points, covariances)) in zip(axes.flat, maps.items()):
        draw_map(axis, points, covariances, times, context.look.colour(name))
        draw_path(axis, jobs[name][0])
        axis.set(title=name, aspect="equal", xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    figure.supxlabel("x [m]", fontsize=9.5)
    figure.supylabel("y [m]", fontsize=9.5)
    return context.figures.save(figure, f"map_{cell.name}", caption(cell, maps, times))


def draw_map(axis: plt.Axes, points: np.ndarray, covariances: np.ndarray, times: int, colour: str) -> None:
    width, height, angle = ellipses(covariances)
    axis.add_collection(EllipseCollection(
        times * width, times * height, angle, units="xy", offsets=points[:, :2],
        offset_transform=axis.transData, facecolors=colour, edgecolors=colour, alpha=0.35, linewidths=0.8))
    axis.plot(points[:, 0], points[:, 1], ".", color=colour, ms=3)


def draw_path(axis: plt.Axes, job: Job) -> None:
    if job.track is not None and job.track.rotation is not None:
        axis.plot(job.track.estimate[:, 0], job.track.estimate[:, 1], color=style.INK, lw=1, alpha=0.5)


def limits(clouds: list[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Landmarks far outside, and maps of runs that went astray, would shrink all others."""
    points = np.concatenate(clouds)[:, :2]
    low, high = np.median([np.quantile(cloud[:, :2], [0.03, 0.97], axis=0) for cloud in clouds], axis=0)
    reach = 0.4 * (high - low)
    low, high = np.maximum(points.min(axis=0), low - reach), np.minimum(points.max(axis=0), high + reach)
    size = max(float((high - low).max()), 1e-9)
    margin = np.maximum(0.06 * size, 0.15 * size - (high - low) / 2)
    return low - margin, high + margin


def caption(cell: Cell, maps: dict, times: int) -> str:
    sizes = "; ".join(f"{name} {len(points)}, {short(500 * float(np.median(ellipses(P)[0])))} mm"
                      for name, (points, P) in maps.items())
    drawn = "at their size" if times == 1 else f"{times} times their size"
    return (f"{cell.title}: number of landmarks and median longer half-axis: {sizes}. Ellipses are drawn {drawn}; the "
            "dark line is the run's own path.")
