# SPDX-License-Identifier: BSD-3-Clause
"""Paths over the truth, from above and from the side."""
import matplotlib.pyplot as plt
import numpy as np

from . import panels, style
from .context import Context
from .figures import Figure
from .page import Section
from .results import Cell
from .track import Track

VIEWS = [("from above: x, y", 0, 1), ("from the side: x, z", 0, 2)]
AXES = "xyz"
MOST_POINTS = 600


def section(context: Context) -> Section:
    out = Section("Trajectories")
    out.say("Paths are aligned with the truth by evo: rotation and shift where a target gives metric scale (SE3), "
            f"and scale where none does (Sim3). At most {context.most_paths} seeds of a strategy are drawn.")
    context.add_figures(out, lambda cell: draw(context, cell), "No run has ground truth.")
    return out


def draw(context: Context, cell: Cell) -> Figure | None:
    tracks = {name: [job.track for job in context.results.done(cell, name)[:context.most_paths] if job.track]
              for name in context.results.strategies_of(cell)}
    longest = max((t for row in tracks.values() for t in row), key=lambda t: len(t.truth), default=None)
    if longest is None:
        return None
    low, high = limits([longest, *(t for row in tracks.values() for t in row)], longest.truth)
    figure, axes = views(high - low)
    for axis, (view, i, j) in zip(axes, VIEWS):
        truth = panels.thinned(longest.truth, MOST_POINTS)
        axis.plot(truth[:, i], truth[:, j], color=style.INK, lw=4.5, alpha=0.3, label="truth")
        for name, row in tracks.items():
            for number, track in enumerate(row):
                path = panels.thinned(track.estimate, MOST_POINTS)
                axis.plot(path[:, i], path[:, j], color=context.look.colour(name), lw=1.3, alpha=0.85,
                          ls=context.look.dashes(name), label=None if number else name)
        axis.plot(*truth[0, [i, j]], "o", color=style.INK, ms=5)
        axis.set(title=view, xlabel=f"{AXES[i]} [m]", ylabel=f"{AXES[j]} [m]", aspect="equal",
                 xlim=(low[i], high[i]), ylim=(low[j], high[j]))
        axis.locator_params(nbins=6)
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=min(6, len(labels)))
    return context.figures.save(figure, f"trajectory_{cell.name}", caption(cell, tracks))


def views(size: np.ndarray):
    """Side by side, or one above the other where the path is much wider than high."""
    wide = max(size[1], size[2]) < 0.5 * size[0]
    width = style.WIDTH_IN if wide else style.WIDTH_IN / 2
    heights = [(width - 1.1) * size[j] / size[0] + 0.8 for _, _, j in VIEWS]
    height = 0.9 + (sum(heights) if wide else max(heights))
    return plt.subplots(2 if wide else 1, 1 if wide else 2, figsize=(style.WIDTH_IN, min(height, 9.0)))


def limits(tracks: list[Track], truth: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Of all paths; but one that flies away must not shrink the truth to a dot: three of its sizes at most."""
    everything = np.concatenate([p for track in tracks for p in (track.truth, track.estimate)])
    middle, size = (truth.max(axis=0) + truth.min(axis=0)) / 2, max(float(np.ptp(truth, axis=0).max()), 1e-9)
    low = np.maximum(everything.min(axis=0), middle - 1.5 * size)
    high = np.minimum(everything.max(axis=0), middle + 1.5 * size)
    margin = np.maximum(0.06 * size, 0.1 * size - (high - low) / 2)  # flat paths have a height as well
    return low - margin, high + margin


def caption(cell: Cell, tracks: dict) -> str:
    flat = [(name, float(track.position_error_m.max())) for name, row in tracks.items() for track in row]
    worst, error = max(flat, key=lambda pair: pair[1])
    best, least = min(flat, key=lambda pair: pair[1])
    return (f"{cell.title}: the wide grey line is the truth, its dot the start. Largest distance from it: "
            f"{1e3 * least:.3g} mm in the best run drawn ({best}), {1e3 * error:.3g} mm in the worst ({worst}).")
