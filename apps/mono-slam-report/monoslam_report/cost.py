# SPDX-License-Identifier: BSD-3-Clause
"""Cost of the validation as a function of n pairs and r rejected ones, with the curves of Guerra 2013."""
import math

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.lines import Line2D

from . import panels, style
from .context import Context
from .figures import Figure
from .page import Section

COLUMNS = ["pairs", "rejected", "nodes", "leaves", "associate_ms"]
HEADROOM = 300  # how far above what was measured the axis of leaves may reach for a curve's sake


def section(context: Context) -> Section:
    out = Section("Cost of validation")
    out.say("A *search* is a frame in which pairs were rejected, as in the first paper: n pairs, r of them rejected. "
            "The paper's curves are leaves of the search tree: eq. 14, 2ⁿ⁻ʳ, for JCBB without its bound, and eq. 15, "
            "n + n² + … + nʳ, for HOHCT, an upper bound of what removing up to r of n pairs can cost. All sequences, "
            "variants and seeds are pooled. *Leaves* are the complete hypotheses that a strategy judged, *nodes* "
            "the incomplete ones that it built on the way, as `frames.csv` counts them.")
    searches = {name: table for name in context.results.strategies if len(table := searches_of(context, name))}
    if not searches:
        out.say("*No frame had a rejected pair.*")
        return out
    counted = {name: table for name, table in searches.items() if table["nodes"].max() > 0}
    if counted:
        out.blocks.append(draw_nodes(context, counted))
    else:
        out.say("*No strategy counts nodes of a search tree.*")
    out.blocks.append(draw_time(context, searches))
    return out


def searches_of(context: Context, strategy: str) -> pd.DataFrame:
    tables = [job.frames[COLUMNS] for job in context.results.jobs if job.strategy == strategy
              and job.frames is not None and set(COLUMNS) <= set(job.frames)]
    if not tables:
        return pd.DataFrame(columns=COLUMNS)
    table = pd.concat(tables, ignore_index=True)
    return table[(table["rejected"] > 0) & (table["pairs"] > table["rejected"])]


def log_eq14(n: np.ndarray, r: float) -> np.ndarray:
    """log10 of 2^n - sum over i = 1..r of 2^(n-i) = 2^(n-r); beyond what a float holds for large n."""
    return (n - r) * math.log10(2)


def log_eq15(n: np.ndarray, r: int) -> np.ndarray:
    """log10 of the sum over i = 1..r of n^i."""
    n = np.maximum(np.asarray(n, float), 1.0)
    highest = r * np.log10(n)
    return highest + np.log10(sum(10.0 ** (i * np.log10(n) - highest) for i in range(1, r + 1)))


def draw_nodes(context: Context, searches: dict[str, pd.DataFrame]) -> Figure:
    everything = pd.concat(searches.values())
    typical_n, typical_r = everything["pairs"].median(), max(1, round(everything["rejected"].median()))
    figure, axes = plt.subplots(1, 2, figsize=(style.WIDTH_IN, 3.9), sharey=True)
    for name, table in searches.items():
        for axis, by in zip(axes, ("pairs", "rejected")):
            points(context, axis, name, table, by, "leaves", hollow=False)
            points(context, axis, name, table, by, "nodes", hollow=True)
    n = np.linspace(everything["pairs"].min(), everything["pairs"].max(), 60)
    r = np.arange(1, int(everything["rejected"].max()) + 1)
    top = HEADROOM * float(everything[["nodes", "leaves"]].max().max())
    curve(axes[0], n, log_eq14(n, typical_r), f"eq. 14, r = {typical_r}", "--", top)
    curve(axes[0], n, log_eq15(n, typical_r), f"eq. 15, r = {typical_r}", "-", top)
    curve(axes[1], r, np.array([log_eq14(typical_n, k) for k in r]), f"eq. 14, n = {typical_n:.0f}", "--", top)
    curve(axes[1], r, np.array([log_eq15(typical_n, k) for k in r]).ravel(), f"eq. 15, n = {typical_n:.0f}", "-", top)
    axes[0].set(xlabel="pairs n", ylabel="count: leaves filled, nodes hollow", yscale="log", ylim=(0.8, top))
    axes[1].set(xlabel="rejected pairs r")
    axes[1].xaxis.get_major_locator().set_params(integer=True)
    for axis in axes:
        axis.legend(loc="lower left", bbox_to_anchor=(0, 1), fontsize=8)
    figure.legend(handles=[Line2D([], [], color=context.look.colour(name), marker=context.look.marker(name), ls="",
                                  label=name) for name in searches], loc="outside lower center", ncols=5)
    return context.figures.save(figure, "nodes", nodes_caption(searches, typical_n, typical_r))


def points(context: Context, axis: plt.Axes, name: str, table: pd.DataFrame, by: str, of: str, hollow: bool) -> None:
    """Median and quartiles over all searches of equal n, or of equal r; zero, on a log axis, is left out."""
    values = table[table[of] > 0].groupby(by)[of].quantile([0.25, 0.5, 0.75]).unstack()
    if values.empty:
        return
    colour = context.look.colour(name)
    spread = [values[0.5] - values[0.25], values[0.75] - values[0.5]]
    axis.errorbar(values.index, values[0.5], spread, fmt=context.look.marker(name), color=colour, ms=4.5,
                  mfc="none" if hollow else colour, elinewidth=0.8, alpha=0.85, label=name if of == "associate_ms" else None)


def curve(axis: plt.Axes, at: np.ndarray, log_value: np.ndarray, label: str, dashes: str, top: float) -> None:
    shown = log_value <= math.log10(top) + 1
    if not (log_value <= math.log10(top)).any():
        label += f": {power(log_value.min())} and more, above"
    axis.plot(at[shown], 10.0 ** log_value[shown], color=style.INK, lw=1.1, ls=dashes, label=label)


def power(log_value: float) -> str:
    """Without a superscript: 52, 5.6e14."""
    if log_value < 5:
        return f"{10 ** log_value:.0f}"
    exponent = math.floor(log_value)
    return f"{10 ** (log_value - exponent):.1f}e{exponent}"


def nodes_caption(searches: dict[str, pd.DataFrame], n: float, r: int) -> str:
    means = "; ".join(f"{name}: {len(t)} searches, n {t['pairs'].mean():.1f}, r {t['rejected'].mean():.2f}, nodes "
                      f"{t['nodes'].mean():.0f} on average" for name, t in searches.items())
    return (f"Nodes and leaves of the search against n and against r: median and quartiles of all searches with the "
            f"same n (left) or r (right). {means}. At the medians n = {n:.0f}, r = {r}: eq. 14 gives "
            f"{power(float(log_eq14(n, r)))} leaves, eq. 15 {power(float(log_eq15(n, r)))}.")


def draw_time(context: Context, searches: dict[str, pd.DataFrame]) -> Figure:
    figure, axes = plt.subplots(1, 2, figsize=(style.WIDTH_IN, 3.6), sharey=True)
    for name, table in searches.items():
        for axis, by in zip(axes, ("pairs", "rejected")):
            points(context, axis, name, table, by, "associate_ms", hollow=False)
    axes[0].set(xlabel="pairs n", ylabel="time of association [ms]", yscale="log")
    axes[1].set(xlabel="rejected pairs r")
    axes[1].xaxis.get_major_locator().set_params(integer=True)
    panels.plain_log(axes[0].yaxis)
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=5)
    means = ", ".join(f"{name} {t['associate_ms'].mean():.2f} ± {t['associate_ms'].std(ddof=0):.2f} ms"
                      for name, t in searches.items())
    return context.figures.save(figure, "association_time", "Time that a frame's association takes in searches, "
                                f"median and quartiles. Mean and standard deviation: {means}.")
