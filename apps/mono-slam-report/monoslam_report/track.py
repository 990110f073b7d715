# SPDX-License-Identifier: BSD-3-Clause
"""A run's path aligned with the truth, by evo."""
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from evo.core import metrics, sync
from evo.core.geometry import GeometryException
from evo.core.sync import SyncException
from evo.core.trajectory import PoseTrajectory3D
from evo.tools import file_interface

TOLERANCE_S = 0.02


@dataclass(frozen=True)
class Track:
    """aligned = scale * rotation * estimate + shift, as is everything else of the run's map."""

    t_s: np.ndarray
    estimate: np.ndarray
    truth: np.ndarray
    position_error_m: np.ndarray
    rotation_error_deg: np.ndarray
    rotation: np.ndarray
    shift: np.ndarray
    scale: float


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
                 position_error_m=error_of(metrics.PoseRelation.translation_part, truth, estimate),
                 rotation_error_deg=error_of(metrics.PoseRelation.rotation_angle_deg, truth, estimate),
                 rotation=rotation, shift=shift, scale=scale)


def read(file: Path) -> PoseTrajectory3D:
    return file_interface.read_tum_trajectory_file(str(file))


def error_of(relation: metrics.PoseRelation, truth: PoseTrajectory3D,
             estimate: PoseTrajectory3D) -> np.ndarray:
    metric = metrics.APE(relation)
    metric.process_data((truth, estimate))
    return metric.error
