# SPDX-License-Identifier: BSD-3-Clause
"""Table 2, beside the paper's figures, and its spread over the seeds."""
import math

import pandas as pd
from monoslam_report.seeds import sign_test, summary

from methods import BY_KEY, METHODS, MHDA

SIGNIFICANT = 0.05


def short(value, digits=3):
    if value is None or math.isnan(value):
        return "-"
    if math.isinf(value):
        return "failed"
    if abs(value) >= 10 ** digits:
        return f"{value:.0f}"
    return f"{value:#.{digits}g}".rstrip(".")


def label_of(key):
    return BY_KEY[key].label if key in BY_KEY else key


def keys_in(runs):
    present = set(runs.method)
    return [method.key for method in METHODS if method.key in present]


def of(runs, key, quantity):
    """Values of a method in the order of their seeds."""
    return runs[runs.method == key].sort_values("seed")[quantity].tolist()


def median(runs, key, quantity):
    return summary(of(runs, key, quantity)).median


def paired(runs, key, other, quantity):
    """Sign test over the seeds that both have; its wins are those of `key`."""
    both = runs[runs.method.isin([key, other])].pivot_table(
        index="seed", columns="method", values=quantity, dropna=False, observed=False)
    if key not in both or other not in both:
        return sign_test([], [])
    both = both.dropna()
    return sign_test(both[key].tolist(), both[other].tolist())


def table2(runs):
    """Medians over the seeds beside the paper's single runs."""
    rows = []
    for key in keys_in(runs):
        own = runs[runs.method == key]
        paper = BY_KEY[key].paper or (math.nan,) * 4
        cells = {"method": label_of(key)}
        for title, value, quantity in (
                ("position [m]", paper[0], "position_m"), ("orientation [rad]", paper[1], "orientation_rad"),
                ("landmarks, mean [m]", paper[2], "landmark_mean_m")):
            cells[f"{title}, paper"] = short(value, 4)
            cells[title] = short(median(runs, key, quantity))
        cells["position after SE3 [m]"] = short(median(runs, key, "position_se3_m"))
        cells["landmarks, median [m]"] = short(median(runs, key, "landmark_median_m"))
        cells["ms a frame, paper"] = short(paper[3], 4)
        cells["ms a frame"] = short(median(runs, key, "frame_ms"))
        cells["worst frame [ms]"] = short(own.worst_ms.max())
        cells["runs"] = len(own)
        cells["of them lost or failed"] = int(((own.lost_frames > 0) | (own.status == "failed")).sum())
        stopped = own.capped_frames if BY_KEY[key].strategy == "jcbb_mrpt" else own.not_proved_frames
        cells["frames stopped at a cap [%]"] = short(100 * stopped.sum() / max(own.frames.sum(), 1))
        rows.append(cells)
    return pd.DataFrame(rows)


# Title: quantity, its unit.
SPREAD = {"position [mm]": ("position_m", 1e3), "after SE3 [mm]": ("position_se3_m", 1e3),
          "orientation [mrad]": ("orientation_rad", 1e3), "landmarks, median [mm]": ("landmark_median_m", 1e3),
          "ms a frame": ("frame_ms", 1.0)}
TESTED = {"position": "position_m", "orientation": "orientation_rad", "landmarks": "landmark_median_m"}


def spread(runs, reference=MHDA):
    """Median, quartiles and worst over the seeds; sign tests of each method against MHDA."""
    rows = []
    for key in keys_in(runs):
        cells = {"method": label_of(key)}
        for title, (quantity, unit) in SPREAD.items():
            s = summary([unit * value for value in of(runs, key, quantity)])
            cells[title] = f"{short(s.median)} ({short(s.quartiles[0])} to {short(s.quartiles[1])}; {short(s.worst)})"
        for title, quantity in TESTED.items():
            cells[f"{title} better than MHDA"] = "-" if key == reference else versus(runs, key, reference, quantity)
        rows.append(cells)
    return pd.DataFrame(rows)


def versus(runs, key, reference, quantity):
    test = paired(runs, key, reference, quantity)
    if test.wins + test.losses + test.ties == 0:
        return "-"
    return f"{test.wins} of {test.wins + test.losses + test.ties} (p {test.p:.2g})"

