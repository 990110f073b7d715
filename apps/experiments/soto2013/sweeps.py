# SPDX-License-Identifier: BSD-3-Clause
"""MHDA against its parameters, and the frame rates of all methods."""
import pandas as pd
from monoslam_report.seeds import summary

from tables import keys_in, label_of, median, of, short

TITLES = {"particles": "P", "p_present": "P_present", "p_search": "P_search", "clutter_per_image": "N_C"}
REAL_TIME_FPS = 30.0


def value_of(variant, parameter):
    return float(variant.removeprefix(f"{parameter}_"))


def points(runs, parameter):
    """A row a value: quartiles of the position error, medians of the rest."""
    own = runs[runs.batch == f"sweep-{parameter}"]
    rows = []
    for (sequence, variant), cell in own.groupby(["sequence", "variant"]):
        error = summary(cell.position_m * 1e3)
        rows.append({"sequence": sequence, "value": value_of(variant, parameter), "runs": len(cell),
                     "position_mm": error.median, "lower_mm": error.quartiles[0], "upper_mm": error.quartiles[1],
                     "worst_mm": error.worst, "orientation_mrad": summary(cell.orientation_rad * 1e3).median,
                     "landmark_median_mm": summary(cell.landmark_median_m * 1e3).median,
                     "frame_ms": summary(cell.frame_ms).median, "lost": int((cell.lost_frames > 0).sum())})
    return pd.DataFrame(rows).sort_values(["sequence", "value"]).reset_index(drop=True)


def table(runs, parameters):
    rows = []
    for parameter in parameters:
        for point in points(runs, parameter).itertuples():
            rows.append({"parameter": TITLES[parameter], "value": f"{point.value:g}", "sequence": point.sequence,
                         "runs": point.runs, "position [mm]": short(point.position_mm),
                         "middle half": f"{short(point.lower_mm)} to {short(point.upper_mm)}",
                         "worst": short(point.worst_mm), "orientation [mrad]": short(point.orientation_mrad),
                         "landmarks, median [mm]": short(point.landmark_median_mm), "ms a frame": short(point.frame_ms),
                         "lost": point.lost})
    return pd.DataFrame(rows)


def fps(runs, key):
    return summary([1000.0 / value for value in of(runs, key, "frame_ms")]).median


def rates_table(runs):
    """Frames a second of one core: of the mean frame and of the slowest; \\param runs  one configuration"""
    rows = []
    for key in keys_in(runs):
        own = runs[runs.method == key]
        rows.append({"method": label_of(key), "frames a second": short(fps(runs, key)),
                     "ms a frame": short(median(runs, key, "frame_ms")), "worst frame [ms]": short(own.worst_ms.max()),
                     "landmarks in view": short(median(runs, key, "visible")),
                     "measured": short(median(runs, key, "matched")), "position [mm]": short(median(runs, key, "position_m") * 1e3),
                     "runs": len(own), "30 frames a second": "yes" if fps(runs, key) >= REAL_TIME_FPS else "no"})
    return pd.DataFrame(rows)
