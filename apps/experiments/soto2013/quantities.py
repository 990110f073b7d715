# SPDX-License-Identifier: BSD-3-Clause
"""What Table 2 measures, of every run: position, orientation, landmarks, time."""
import math
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import pandas as pd
from evo.core import metrics, sync
from evo.tools import file_interface

# The target gives scale and world. SE3 by positions would turn a path that is next to straight by any angle.
METRIC = "none"
QUANTITIES = ["position_m", "position_se3_m", "orientation_rad", "landmark_mean_m", "landmark_median_m"]
FROM_RESULTS = {"landmark_mean_m": "none_landmark_mean_m", "landmark_median_m": "none_landmark_median_m",
                "landmark_count": "landmark_count", "gap_pct": "gap_pct", "lost_frames": "run_frames_lost"}


def errors_over_time(folder, alignment=METRIC):
    """Position [m] and rotation error [rad] of every frame that has a pose, with its time."""
    true = file_interface.read_tum_trajectory_file(folder / "groundtruth.tum")
    estimate = file_interface.read_tum_trajectory_file(folder / "trajectory.tum")
    true, estimate = sync.associate_trajectories(true, estimate, max_diff=0.005)
    if alignment != METRIC:
        estimate.align(true, correct_scale=alignment == "Sim3")
    parts = []
    for relation in (metrics.PoseRelation.translation_part, metrics.PoseRelation.rotation_angle_rad):
        ape = metrics.APE(relation)
        ape.process_data((true, estimate))
        parts.append(ape.error)
    return pd.DataFrame({"t_s": estimate.timestamps, "position_m": parts[0], "orientation_rad": parts[1]})


def of_run(folder, alignment=METRIC):
    """\\param folder  of a finished job"""
    frames = pd.read_csv(folder / "frames.csv")
    # The first frame finds the target and all corners in a process that has just begun.
    times = frames.total_ms.iloc[1:] if len(frames) > 1 else frames.total_ms
    found = {"frame_ms": times.mean(), "worst_ms": times.max(), "capped_frames": int((frames.capped > 0).sum()),
             "not_proved_frames": int((frames.proved == 0).sum()),
             "visible": frames.visible.iloc[1:].mean(), "matched": frames.matched.iloc[1:].mean(),
             "rejected_share": frames.rejected.sum() / max(frames.pairs.sum(), 1)}
    if alignment is None:
        return found
    errors = errors_over_time(folder, alignment)
    return {**found, "position_m": errors.position_m.mean(), "orientation_rad": errors.orientation_rad.mean()}


def measure(rows, output, alignments=None, jobs=2):
    """The rows of runs with their quantities; a failed run's are infinite.

    \\param alignments  {sequence: none, SE3, Sim3 or None for no truth}; METRIC where nothing is said
    """
    rows = rows.reset_index(drop=True)
    done = rows[rows.status == "done"]
    wanted = [(alignments or {}).get(name, METRIC) for name in done.sequence]
    with ProcessPoolExecutor(jobs) as pool:
        found = pool.map(of_run, [output / folder for folder in done.folder], wanted, chunksize=8)
        measured = pd.DataFrame(list(found), index=done.index)
    measured = measured.reindex(rows.index).assign(
        position_se3_m=column(rows, "SE3_ate_mean_mm") / 1000.0,
        method=[method_key(*pair) for pair in zip(rows.strategy, rows.variant)],
        **{name: column(rows, source) for name, source in FROM_RESULTS.items()})
    measured.loc[rows.status == "failed", QUANTITIES] = math.inf
    return pd.concat([rows.drop(columns=rows.columns.intersection(measured.columns)), measured], axis=1)


def column(rows, name):
    return rows[name] if name in rows else pd.Series(np.nan, index=rows.index)


def method_key(strategy, variant):
    return strategy if variant == "plain" else f"{strategy}/{variant}"
