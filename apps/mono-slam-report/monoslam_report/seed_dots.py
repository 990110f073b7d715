# SPDX-License-Identifier: BSD-3-Clause
"""Every seed as a dot: medians hide runs that went astray."""
import math

import matplotlib.pyplot as plt
import numpy as np

from . import panels, style
from .context import Context
from .figures import Figure
from .results import Cell


def draw(context: Context, cell: Cell, seeds: dict[str, dict[int, float]], label: str) -> Figure:
    figure, axis = plt.subplots(figsize=(style.WIDTH_IN, 0.9 + 0.34 * len(seeds)))
    failed = 0
    for row, (name, found) in enumerate(seeds.items()):
        finite = np.array([v for v in found.values() if math.isfinite(v)])
        lost = sum(math.isinf(v) for v in found.values())
        failed += lost
        offsets = np.linspace(-0.2, 0.2, len(finite)) if len(finite) > 1 else np.zeros(len(finite))
        colour = context.look.colour(name)
        axis.plot(finite, row + offsets, context.look.marker(name), color=colour, ms=5, alpha=0.7, mew=0)
        if finite.size:
            axis.plot([np.median(finite)] * 2, [row - 0.36, row + 0.36], color=style.INK, lw=2, zorder=1)
        if lost:
            axis.annotate(f"{lost} failed", (1, row), xycoords=("axes fraction", "data"), ha="right", va="center",
                          color=style.INK, fontsize=9)
    axis.set_yticks(range(len(seeds)), list(seeds))
    axis.set_ylim(len(seeds) - 0.4, -0.6)
    axis.set_xlabel(label)
    every = np.array([v for found in seeds.values() for v in found.values() if math.isfinite(v) and v > 0])
    if every.size and every.max() > panels.LOG_FROM * every.min():
        axis.set_xscale("log")
        panels.plain_log(axis.xaxis)
    elif every.size:
        axis.set_xlim(left=0)
    axis.grid(axis="y", visible=False)
    lost = f" {failed} runs failed and have no dot." if failed else ""
    return context.figures.save(figure, f"seeds_{cell.name}", f"{cell.title}: a dot a seed; the bar is the median of "
                                f"those that ended.{lost}")
