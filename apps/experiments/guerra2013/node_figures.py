# SPDX-License-Identifier: BSD-3-Clause
"""Figures of the searches: sizes, place on the track, nodes against n and r, times."""
import matplotlib.pyplot as plt
import numpy as np
from cost import equation_14, hohct_nodes
from node_tables import of
from plan import BOUNDED, PRINTED, TREE, UNBOUNDED, WHOLE_RUNS
from plots import BLUE, COLOURS, ORANGE, save


def sizes(problems, output):
    mine = of(problems, PRINTED)
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.2), layout="constrained")
    left.hist(mine.n, bins=np.arange(mine.n.min(), mine.n.max() + 2) - 0.5, color=BLUE)
    left.set(xlabel="pairs n", ylabel="searches")
    right.hist(mine.r, bins=np.arange(1, mine.r.max() + 2) - 0.5, color=ORANGE)
    right.set(xlabel="rejected pairs r", ylabel="searches")
    save(figure, output, "sizes")


def places(problems, runs, output):
    """Searches against the position along the track, and by sequence."""
    mine = of(problems, PRINTED)
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.8), layout="constrained")
    left.hist(100 * mine.track, bins=np.linspace(0, 100, 11), color=BLUE)
    left.set(xlabel="position along the track [% of the frames]", ylabel="searches, all runs")
    frames = runs.groupby("sequence", sort=False).frames.sum()
    shares = 100 * mine.groupby("sequence").size().reindex(frames.index, fill_value=0) / frames
    right.barh(shares.index, shares, color=BLUE)
    right.axvline(100 / 7, color="black", linestyle=":", label="1/7, the paper's bound")
    right.invert_yaxis()
    right.set(xlabel="frames with a search [%]")
    right.tick_params(axis="y", labelsize=7)
    right.legend(fontsize=8)
    save(figure, output, "places")


def nodes(problems, output):
    """Nodes against n for r = 1 and for all, with what the equations say."""
    figure, axes = plt.subplots(1, 2, figsize=(10, 4), layout="constrained", sharey=True)
    for axis, first, second in ((axes[0], UNBOUNDED, PRINTED), (axes[1], BOUNDED, TREE)):
        for shift, method in ((-0.12, first), (0.12, second)):
            mine = of(problems, method)
            axis.scatter(mine.n + shift, np.maximum(mine.nodes, 1), s=8 + 6 * mine.r, alpha=0.35,
                         color=COLOURS[method.name], label=method.title, edgecolors="none")
        axis.set(yscale="log", xlabel="pairs n (larger dots: more rejected)")
    n = np.arange(of(problems, PRINTED).n.min(), of(problems, PRINTED).n.max() + 1)
    axes[0].plot(n, equation_14(n, 1), color=COLOURS[UNBOUNDED.name], linestyle="--",
                 label="eq. 14, r = 1 (leaves)")
    axes[0].plot(n, [hohct_nodes(k, 1) for k in n], color=COLOURS[PRINTED.name], linestyle="--",
                 label="sum C(n+1, i), r = 1")
    axes[0].set(ylabel="nodes of a search")
    for axis in axes:
        axis.legend(fontsize=8)
    save(figure, output, "nodes")


def times(frames, output):
    """Share of the frames that take longer than t."""
    figure, axis = plt.subplots(figsize=(6.5, 3.8), layout="constrained")
    for method in WHOLE_RUNS:
        values = np.sort(frames.total_ms[frames.variant == method.name])
        axis.step(values, 1 - np.arange(len(values)) / len(values), label=method.title,
                  color=COLOURS[method.name])
    for limit in (33, 40):
        axis.axvline(limit, color="black", linestyle=":")
    axis.set(xscale="log", yscale="log", xlabel="CPU time of a frame [ms]; dots: 33 and 40 ms",
             ylabel="share of the frames that take longer")
    axis.legend(fontsize=8)
    save(figure, output, "times")
