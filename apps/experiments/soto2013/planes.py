# SPDX-License-Identifier: BSD-3-Clause
"""Does a method take landmarks off the majority's depth plane as outliers? Rejections by true depth."""
import numpy as np
import pandas as pd

from moved_object import read_depth
from tables import keys_in, label_of, short

NAMES = ("near", "middle", "far")


class Depths:
    """True depth [m] at a pixel of a frame."""

    def __init__(self, folder):
        self.folder = folder
        self.pictures = {}

    def at(self, frames, u, v):
        depth = np.empty(len(frames))
        for frame in np.unique(frames):
            if frame not in self.pictures:
                self.pictures[frame] = read_depth(self.folder, frame).astype(np.float32)
            picture, chosen = self.pictures[frame], frames == frame
            row = np.clip(np.rint(v[chosen]).astype(int), 0, picture.shape[0] - 1)
            column = np.clip(np.rint(u[chosen]).astype(int), 0, picture.shape[1] - 1)
            depth[chosen] = picture[row, column]
        return depth


def pairs_of(run, output, depths):
    """Depth and fate of every pair of a run, at the predicted pixel: that of a wrong match tells nothing."""
    a = pd.read_csv(output / run.folder / "associations.csv", usecols=["index", "fate", "h_u_px", "h_v_px"])
    a = a[a.fate.isin(["matched", "rejected"])]
    depth = depths.at(a["index"].to_numpy(), a.h_u_px.to_numpy(), a.h_v_px.to_numpy())
    found = pd.DataFrame({"method": run.method, "depth_m": depth, "rejected": a.fate.to_numpy() == "rejected"})
    return found[found.depth_m > 0]


def collect(runs, output, folder, seeds):
    """Pairs of the first seeds, each in its third of all depths."""
    depths = Depths(folder)
    chosen = runs[(runs.status == "done") & (runs.seed <= seeds)]
    pairs = pd.concat([pairs_of(run, output, depths) for run in chosen.itertuples()], ignore_index=True)
    pairs["third"] = pd.qcut(pairs.depth_m, 3, labels=NAMES)
    return pairs


def shares(pairs):
    """Rejected share of the pairs, a row a method, a column a third of the depth."""
    return pairs.pivot_table(index="method", columns="third", values="rejected", aggfunc="mean", observed=False)


def table(pairs):
    share, limits = shares(pairs), pairs.groupby("third", observed=False).depth_m.agg(["min", "max"])
    rows = []
    for key in keys_in(pairs):
        own = share.loc[key]
        rows.append({"method": label_of(key), **{
            f"{name}: {limits.loc[name, 'min']:.2f} to {limits.loc[name, 'max']:.2f} m, rejected [%]":
                short(100 * own[name]) for name in NAMES},
            "largest over smallest": short(own.max() / own.min()) if own.min() > 0 else "-"})
    return pd.DataFrame(rows)
