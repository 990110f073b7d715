# SPDX-License-Identifier: BSD-3-Clause
"""Figures, as SVG and PNG; colours are Okabe and Ito's, which colour-blind readers tell apart."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import matplotlib.ticker as ticker  # noqa: E402
import numpy as np  # noqa: E402

import planes  # noqa: E402
import sweeps  # noqa: E402
from methods import BY_KEY, MHDA  # noqa: E402
from quantities import errors_over_time  # noqa: E402
from tables import keys_in, label_of, median, of  # noqa: E402

BLUE, ORANGE, GREEN, RED, GREY = "#0072B2", "#E69F00", "#009E73", "#D55E00", "#888888"
COLOURS = {"paper": BLUE, "ours": ORANGE}
NAMES = {"paper": "the paper's settings", "ours": "our defaults"}
plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False,
                     "axes.spines.right": False, "figure.constrained_layout.use": True, "svg.hashsalt": "soto2013"})


def save(figure, folder, name):
    for kind in ("svg", "png"):
        figure.savefig(folder / f"{name}.{kind}", dpi=150, metadata={"Date": None} if kind == "svg" else None)
    plt.close(figure)


def plain_numbers(axis):
    """Ticks of a logarithmic axis at 1, 2 and 5, as numbers."""
    axis.yaxis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
    axis.yaxis.set_major_formatter("{x:g}")
    axis.yaxis.set_minor_locator(ticker.NullLocator())


def table2(by_configuration, folder, name):
    """Every run a dot, the paper's single run a cross."""
    quantities = [("position_m", 0, "position error [m]"), ("orientation_rad", 1, "orientation error [rad]"),
                  ("landmark_mean_m", 2, "landmark error, mean [m]"),
                  ("frame_ms", 3, "time a frame [ms]")]
    keys = keys_in(next(iter(by_configuration.values())))
    figure, axes = plt.subplots(1, 4, figsize=(14, 0.36 * len(keys) + 1.6), sharey=True)
    for axis, (quantity, column, title) in zip(axes, quantities):
        for offset, (configuration, runs) in zip((-0.17, 0.17), by_configuration.items()):
            for row, key in enumerate(keys):
                values = np.array(of(runs, key, quantity), dtype=float)
                spread = row + offset + np.linspace(-0.1, 0.1, len(values)) if len(values) > 1 else [row + offset]
                axis.plot(values, spread, ".", ms=3.5, color=COLOURS[configuration], alpha=0.7,
                          label=NAMES[configuration] if row == 0 else None)
                axis.plot([median(runs, key, quantity)], [row + offset], "|", ms=11, mew=2, color=COLOURS[configuration])
        for row, key in enumerate(keys):
            if BY_KEY[key].paper:
                axis.plot(BY_KEY[key].paper[column], row, "x", color="black", ms=6, label="the paper" if row == 0 else None)
        axis.set(xscale="log", xlabel=title)
    axes[0].set_yticks(range(len(keys)), [label_of(key) for key in keys])
    axes[0].invert_yaxis()
    axes[-1].legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False)
    save(figure, folder, name)


def error_bands(runs, output):
    """(t, quartiles of the position error in mm) over the seeds of one method."""
    errors = [errors_over_time(output / folder).set_index("t_s").position_m * 1e3 for folder in runs.folder]
    table = np.ma.masked_invalid(np.array([e.reindex(errors[0].index).to_numpy() for e in errors], dtype=float))
    return errors[0].index.to_numpy(), np.nanpercentile(table.filled(np.nan), [25, 50, 75], axis=0)


def recovery(moved, controls, output, frames, folder):
    """Position error over time: median and middle half of the seeds, with and without the displacement."""
    keys = keys_in(moved)
    columns = 4
    figure, axes = plt.subplots(-(-len(keys) // columns), columns, sharex=True, sharey=True, squeeze=False,
                                figsize=(13, 2.1 * -(-len(keys) // columns) + 0.6))
    for axis, key in zip(axes.flat, keys):
        for runs, colour, label in ((controls, GREY, "nothing moves"), (moved, BLUE, "an object is displaced")):
            own = runs[(runs.method == key) & (runs.status == "done")]
            if len(own):
                t, (lower, middle, upper) = error_bands(own, output)
                axis.fill_between(t, lower, upper, color=colour, alpha=0.25, lw=0)
                axis.plot(t, middle, color=colour, label=label)
        axis.axvspan(*(t[frame] for frame in frames), color=RED, alpha=0.2, lw=0)
        axis.set(yscale="log")
        plain_numbers(axis)
        axis.set_title(label_of(key), fontweight="bold" if key == MHDA else "normal", fontsize=9)
    for axis in axes.flat[len(keys):]:
        axis.set_axis_off()
    figure.supxlabel("time [s]", fontsize=9)
    figure.supylabel("position error [mm]", fontsize=9)
    axes.flat[0].legend(fontsize=7)
    save(figure, folder, "recovery")


def sweep(runs, parameters, folder):
    figure, axes = plt.subplots(2, len(parameters), figsize=(3.3 * len(parameters), 5), squeeze=False)
    for (top, bottom), parameter in zip(axes.T, parameters):
        points = sweeps.points(runs, parameter)
        for colour, (sequence, own) in zip((BLUE, RED), points.groupby("sequence", sort=False)):
            top.errorbar(own.value, own.position_mm, [own.position_mm - own.lower_mm, own.upper_mm - own.position_mm],
                         fmt="o-", color=colour, capsize=2, ms=4, label=sequence)
            bottom.plot(own.value, own.frame_ms, "o-", color=colour, ms=4, label=sequence)
        for axis in (top, bottom):
            axis.set(xlabel=sweeps.TITLES[parameter], xscale="log" if points.value.min() >= 1 else "logit")
            axis.set_xticks(points.value.unique(), [f"{v:g}" for v in points.value.unique()], fontsize=7)
            axis.minorticks_off()
        top.set(yscale="log")
        plain_numbers(top)
        bottom.set_ylim(bottom=0)
    axes[0, 0].set_ylabel("position error [mm]")
    axes[1, 0].set_ylabel("time a frame [ms]")
    axes[0, 0].legend(fontsize=7)
    save(figure, folder, "sweeps")


def rates(by_configuration, folder):
    keys = keys_in(next(iter(by_configuration.values())))
    figure, axis = plt.subplots(figsize=(8, 0.34 * len(keys) + 1.2))
    for offset, (configuration, runs) in zip((-0.2, 0.2), by_configuration.items()):
        axis.barh(np.arange(len(keys)) + offset, [sweeps.fps(runs, key) for key in keys], 0.38,
                  color=COLOURS[configuration], label=NAMES[configuration])
    axis.axvline(sweeps.REAL_TIME_FPS, color="black", ls="--", lw=1, label=f"{sweeps.REAL_TIME_FPS:g} a second")
    axis.set_yticks(range(len(keys)), [label_of(key) for key in keys])
    axis.set(xscale="log", xlabel="frames a second of one core (mean frame, median run)")
    axis.invert_yaxis()
    axis.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False)
    save(figure, folder, "rates")


def depth_planes(pairs, folder):
    share, keys = planes.shares(pairs) * 100, keys_in(pairs)
    figure, axis = plt.subplots(figsize=(8, 0.34 * len(keys) + 1.2))
    for offset, colour, third in zip((-0.27, 0, 0.27), (BLUE, ORANGE, GREEN), planes.NAMES):
        axis.barh(np.arange(len(keys)) + offset, share.loc[keys, third], 0.26, color=colour, label=f"{third} third")
    axis.set_yticks(range(len(keys)), [label_of(key) for key in keys])
    axis.set(xlabel="pairs rejected [%], by true depth of the landmark")
    axis.invert_yaxis()
    axis.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False)
    save(figure, folder, "depth_planes")
