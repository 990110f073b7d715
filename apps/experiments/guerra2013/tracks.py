# SPDX-License-Identifier: BSD-3-Clause
"""Figures of one run's path: the straight's length, the turn's opening, the closing gap."""
import numpy as np
from evo.core.sync import associate_trajectories
from evo.tools.file_interface import read_tum_trajectory_file

UP = np.array([0.0, 0.0, 1.0])  # the rendered worlds are right-handed, z up


def read(file):
    return read_tum_trajectory_file(str(file))


def matched(truth, estimate, period_s):
    """Poses of the same frames."""
    return associate_trajectories(truth, estimate, max_diff=period_s / 4)


class Track:
    """True and estimated poses of the frames that have both, aligned by the first pose.

    A metric run needs no scale, but a rectangle does not tell which of its long sides is the front.
    """

    def __init__(self, sequence, run_folder):
        self.sequence = sequence
        period_s = float(np.median(np.diff(sequence.times)))
        self.truth, self.estimate = matched(read(sequence.truth), read(run_folder / "trajectory.tum"),
                                            period_s)
        self.alignment = self.estimate.align_origin(self.truth)
        self.frames = np.searchsorted(np.asarray(sequence.times) + period_s / 2,
                                      self.truth.timestamps)

    def aligned(self, points):
        """The map's points where the aligned path has them."""
        return points @ self.alignment[:3, :3].T + self.alignment[:3, 3]

    def ends(self, segment):
        """Indices of a segment's first and last pose; nothing where one has no estimate.

        A run that has found its target some frames late begins with its first pose.
        """
        first = max(segment[0], int(self.frames[0]))
        places = [np.flatnonzero(self.frames == frame) for frame in (first, segment[1])]
        return [int(place[0]) for place in places] if all(map(len, places)) else None


def chord(path, ends):
    """Distance between the segment's ends [m]."""
    return float(np.linalg.norm(path.positions_xyz[ends[1]] - path.positions_xyz[ends[0]]))


def opening(path, ends):
    """Heading change over the segment about the vertical, summed up from frame to frame [deg]."""
    axes = path.poses_se3
    headings = [np.arctan2(*(axes[k][:2, :3] @ np.array([0.0, 0.0, 1.0]))[::-1])
                for k in range(ends[0], ends[1] + 1)]
    return float(np.degrees(np.sum(np.diff(np.unwrap(headings)))))


def gap(track, ends):
    """Between the end as estimated and as it is, both seen from the start [m]."""
    steps = [path.positions_xyz[ends[1]] - path.positions_xyz[ends[0]]
             for path in (track.estimate, track.truth)]
    return float(np.linalg.norm(steps[0] - steps[1]))


def whole(sequence):
    return 0, sequence.frames - 1


def figures(sequence, run_folder):
    """Name: (estimate, truth); the gap's truth is 0. Absent: no estimate where it is needed."""
    track = Track(sequence, run_folder)
    segments = sequence.marks.get("segments", {})
    found = {}
    for name, key, measure in (("straight, length [m]", "straight", chord),
                               ("turn, opening [deg]", "turn", opening)):
        ends = track.ends(segments[key]) if key in segments else None
        if ends:
            found[name] = measure(track.estimate, ends), measure(track.truth, ends)
    ends = track.ends(whole(sequence))
    if ends:
        found["closing gap [m]"] = gap(track, ends), 0.0
    return found
