# SPDX-License-Identifier: BSD-3-Clause
"""A run's path aligned with the truth, by evo."""
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd
from evo.core import metrics, sync
from evo.core.geometry import GeometryException
from evo.core.sync import SyncException
from evo.core.trajectory import PoseTrajectory3D
from evo.tools import file_interface
from scipy.spatial.transform import Rotation

TOLERANCE_S = 0.02


@dataclass(frozen=True)
class Track:
    """aligned = scale * rotation * estimate + shift, as is everything else of the run's map; None where
    only the aligned path is known."""

    t_s: np.ndarray
    estimate: np.ndarray
    truth: np.ndarray
    position_error_m: np.ndarray
    rotation_error_deg: np.ndarray
    rotation: np.ndarray | None
    shift: np.ndarray | None
    scale: float | None


def track_of(folder: Path, with_scale: bool) -> Track | None:
    """None without truth or without a pose. \\throws ValueError on damaged files"""
    files = [folder / "groundtruth.tum", folder / "trajectory.tum"]
    if not all(file.exists() and file.stat().st_size for file in files):
        return None
    try:
        truth, estimate = sync.associate_trajectories(*map(read, files), max_diff=TOLERANCE_S)
        rotation, shift, scale = estimate.align(truth, correct_scale=with_scale)
    except (file_interface.FileInterfaceException, SyncException, GeometryException) as error:
        raise ValueError(str(error).splitlines()[0]) from None
    return Track(t_s=truth.timestamps, estimate=estimate.positions_xyz, truth=truth.positions_xyz,
                 position_error_m=position_error(truth, estimate),
                 rotation_error_deg=own_rotation_error_deg(truth, estimate),
                 rotation=rotation, shift=shift, scale=scale)


def track_from_errors(table: pd.DataFrame) -> Track | None:
    """Where the rawlog has no truth of its own: errors.csv has both paths, aligned by mono-slam-eval."""
    names = [[f"{kind}{axis}_m" for axis in "xyz"] for kind in ("", "true_")]
    if not {"position_error_m", "rotation_error_rad", *names[0], *names[1]} <= set(table):
        return None
    estimate, truth = (table[columns].to_numpy(float) for columns in names)
    return Track(t_s=table["t_s"].to_numpy(float), estimate=estimate, truth=truth,
                 position_error_m=table["position_error_m"].to_numpy(float),
                 rotation_error_deg=np.degrees(table["rotation_error_rad"].to_numpy(float)),
                 rotation=None, shift=None, scale=None)


def read(file: Path) -> PoseTrajectory3D:
    return file_interface.read_tum_trajectory_file(str(file))


def position_error(truth: PoseTrajectory3D, estimate: PoseTrajectory3D) -> np.ndarray:
    metric = metrics.APE(metrics.PoseRelation.translation_part)
    metric.process_data((truth, estimate))
    return metric.error


def own_rotation_error_deg(truth: PoseTrajectory3D, estimate: PoseTrajectory3D) -> np.ndarray:
    """After the rotation that fits all orientations best, as rotation_own_rms_deg of mono-slam-eval:
    that which fits the positions is arbitrary for a path along a line."""
    turned = orientations(truth) * orientations(estimate).inv()
    return np.degrees((turned.mean().inv() * turned).magnitude())


def orientations(path: PoseTrajectory3D) -> Rotation:
    return Rotation.from_quat(path.orientations_quat_wxyz, scalar_first=True)
