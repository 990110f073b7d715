# SPDX-License-Identifier: BSD-3-Clause
"""Figure 5: paths and maps of trajectories 1 and 2 over the truth, with validation and without."""
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from batches import done
from initialization import errors
from plan import FEATURES, initialization_variants
from plots import BLUE, GREEN, GREY, ORANGE, save
from tracks import Track


def median_run(rows, name, variant):
    """The run whose error is the median of its seeds, the lower of two; nothing if all failed."""
    runs = done(rows[(rows.sequence == name) & (rows.variant == variant.name)])
    runs = runs.sort_values(["SE3_ate_rmse_mm", "seed"])
    return runs.iloc[(len(runs) - 1) // 2] if len(runs) else None


def draw(axis, sequence, row, output, title):
    track = Track(sequence, output / row.folder)
    points = pd.read_csv(output / row.folder / "map.csv")
    places = track.aligned(points[["x_m", "y_m", "z_m"]].to_numpy())
    true, found = track.truth.positions_xyz, track.estimate.positions_xyz
    axis.plot(true[:, 0], true[:, 1], color=GREY, linestyle="--", label="true path")
    axis.plot(found[:, 0], found[:, 1], color=BLUE, label="estimated path")
    axis.plot(found[0, 0], found[0, 1], "o", color=BLUE, markersize=4)
    span = np.vstack([true[:, :2], found[:, :2]])
    low, high = span.min(axis=0) - 1.0, span.max(axis=0) + 1.0
    inside = places[((places[:, :2] > low) & (places[:, :2] < high)).all(axis=1)]
    axis.plot(inside[:, 0], inside[:, 1], ".", color=ORANGE, markersize=4,
              label=f"landmarks ({len(inside)} of {len(places)} in this part)")
    axis.set(title=f"{title}, seed {row.seed}: ATE {row.SE3_ate_rmse_mm:.0f} mm", aspect="equal",
             xlabel="x [m]", ylabel="y [m]")
    axis.legend(fontsize=7)


def figure5(output, sequences, rows, variants, name):
    """One sequence of either kind, the first that is there. Returns whether there is one."""
    chosen = []
    for kind in ("uturn", "turn"):
        chosen += [s for s in sequences if s.kind == kind][:1]
    if not chosen:
        return False
    figure, axes = plt.subplots(len(chosen), 2, figsize=(11, 4.6 * len(chosen)),
                                layout="constrained", squeeze=False, sharex="row", sharey="row")
    for line, sequence in zip(axes, chosen):
        for axis, variant in zip(line, variants):
            row = median_run(rows, sequence.name, variant)
            if row is None:
                axis.set(title=f"{sequence.name}, {variant.title}: all runs failed")
                continue
            draw(axis, sequence, row, output, f"{sequence.name}, {variant.title}")
    save(figure, output, name)
    return True


def initialization(rows, output):
    """Error of every run at 12, 25 and 50 features."""
    figure, axis = plt.subplots(figsize=(6.5, 3.8), layout="constrained")
    for shift, method, colour in ((-0.18, "delayed", BLUE), (0.18, "undelayed", ORANGE)):
        groups = [errors(rows, initialization_variants()[method, n]) for n in FEATURES]
        finite = [group[np.isfinite(group)] for group in groups]
        places = np.arange(len(FEATURES)) + shift
        boxes = axis.boxplot(finite, positions=places, widths=0.3, patch_artist=True,
                             medianprops={"color": "black"}, flierprops={"markersize": 3})
        for box in boxes["boxes"]:
            box.set_facecolor(colour)
        axis.plot([], [], color=colour, linewidth=8, label=method)
    axis.set(yscale="log", ylabel="ATE after SE3 [mm], runs", xlabel="features measured in a frame")
    axis.set_xticks(range(len(FEATURES)), [str(n) for n in FEATURES])
    axis.legend()
    save(figure, output, "initialization")


def gaps(measured, variants, output):
    """Errors of the straight, the turn and the gap, every run with validation against none."""
    validated, none = (variant.name for variant in variants)
    names = list(dict.fromkeys(measured.figure))
    figure, axes = plt.subplots(1, len(names), figsize=(4 * len(names), 3.8), layout="constrained",
                                squeeze=False)
    for axis, name in zip(axes[0], names):
        mine = measured[measured.figure == name].pivot(index=["sequence", "seed"],
                                                       columns="variant", values="error")
        both = mine[np.isfinite(mine).all(axis=1)]
        axis.loglog(both[none], both[validated], ".", color=GREEN, alpha=0.6)
        limits = [both.min().min() * 0.8, both.max().max() * 1.25] if len(both) else [0.1, 1]
        axis.plot(limits, limits, color="black", linestyle=":", label="equal")
        axis.set(title=f"error of the {name}", xlabel="no validation", ylabel="HOHCT")
        axis.legend(fontsize=8)
    save(figure, output, "gaps")
