# SPDX-License-Identifier: BSD-3-Clause
"""Small multiples: one row of panels a strategy, columns that share their axes."""
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.ticker import LogFormatter

from . import style

ROW_IN = 1.5
LOG_FROM = 30  # where curves differ by more than this factor, a linear axis shows only the worst


def grid(strategies: list[str], columns: list[str], xlabel: str, sharey="col"):
    """\\return figure, axes[strategy][column]"""
    figure, axes = plt.subplots(len(strategies), len(columns), sharex=True, sharey=sharey, squeeze=False,
                                figsize=(style.WIDTH_IN, 0.75 + ROW_IN * len(strategies)))
    for row, strategy in zip(axes, strategies):
        for axis, label in zip(row, columns):
            axis.set_ylabel(label)
            axis.margins(x=0.01)
        row[0].set_title(strategy)
    for axis in axes[-1]:
        axis.set_xlabel(xlabel)
    return figure, dict(zip(strategies, axes))


def plain_log(axis) -> None:
    """1, 20, 300 instead of powers of ten, which only help across many decades."""
    axis.set_major_formatter("{x:g}")
    axis.set_minor_formatter(LogFormatter(minor_thresholds=(1.5, 0.5)))


def draw_band(axis: plt.Axes, table: pd.DataFrame, colour: str, factor: float = 1.0) -> None:
    """Median as a line, quartiles dark, extremes light; NaN rows leave a gap."""
    at = table["at"]
    axis.fill_between(at, factor * table["least"], factor * table["most"], color=colour, alpha=0.16, lw=0)
    axis.fill_between(at, factor * table["lower"], factor * table["upper"], color=colour, alpha=0.32, lw=0)
    axis.plot(at, factor * table["median"], color=colour)


def log_if_wide(axes: list[plt.Axes], medians: list[pd.Series]) -> None:
    """A logarithmic axis where the strategies' own errors differ too much for a linear one."""
    typical = [float(m[m > 0].median()) for m in medians if (m > 0).any()]
    if not typical or max(typical) < LOG_FROM * min(typical):
        for axis in axes:
            axis.set_ylim(bottom=0)
        return
    floor = min(float(m[m > 0].quantile(0.02)) for m in medians if (m > 0).any())
    for axis in axes:
        axis.set_yscale("log")
        axis.set_ylim(bottom=floor / 2)


def say_no_data(axis: plt.Axes, text: str = "no data") -> None:
    axis.text(0.5, 0.5, text, transform=axis.transAxes, ha="center", va="center", color=style.MUTED)


def thinned(values: np.ndarray, most: int) -> np.ndarray:
    """Every nth row, first and last among them, so that at most so many are left."""
    if len(values) <= most:
        return values
    return values[np.unique(np.linspace(0, len(values) - 1, most).round().astype(int))]
