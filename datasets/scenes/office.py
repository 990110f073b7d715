# SPDX-License-Identifier: BSD-3-Clause
"""The office table: a hand-held-like path of 600 frames, and its first 200 with a carton that is displaced."""

import math

import numpy as np

import trajectory as tj
from sequence import Box, Camera, Sequence, ease, pose_rows

CAMERA = Camera(640, 480, 481.2, 480.0, 319.5, 239.5)
RATE_HZ, FRAMES, FRAMES_MOVED = 30.0, 600, 200
MOVED_FROM, MOVED_TO = 100, 112
QUICK_FRAMES, QUICK_MOVED_FROM, QUICK_MOVED_TO = 40, 16, 22
MOVED_BY_M = np.array([0.055, -0.015, 0.0])


def path():
    """Three slow figures of different length in x, y and z, and the tremor of a hand."""
    t = np.arange(FRAMES) / RATE_HZ
    a = 2 * math.pi * (t - 0.35 * np.minimum(t, 0.7)) / 9.0
    rng = np.random.default_rng(41)
    centre = np.column_stack(
        [
            0.36 * np.sin(a) + 0.06 * np.sin(2.7 * a),
            -0.66 + 0.10 * np.sin(1.6 * a) - 0.05 * np.sin(0.5 * a),
            0.52 + 0.09 * np.sin(1.25 * a + 0.3),
        ]
    )
    target = np.column_stack(
        [
            -0.16 * np.sin(a + 0.4) + 0.16 * np.sin(0.45 * a) + 0.07,
            0.10 + 0.14 * np.sin(0.8 * a) ** 2,
            0.03 + 0.09 * np.sin(0.8 * a) ** 2,
        ]
    )
    roll = 0.08 * np.sin(0.6 * a) - 0.05 * np.sin(1.4 * a)
    centre += tj.tremor(rng, t, 0.0022, 2.0)
    target += tj.tremor(rng, t, 0.0035, 2.4)
    return pose_rows(RATE_HZ, centre, [tj.look_at(c, p, r) for c, p, r in zip(centre, target, roll)])


def carton(frame, moved):
    """The carton that the camera faces; moved: frames from and to, or nothing."""
    shift = float(ease((frame - moved[0]) / (moved[1] - moved[0]))) * MOVED_BY_M if moved else np.zeros(3)
    return [Box(tuple(np.array([0.19, 0.33, 0.0]) + shift), (0.22, 0.14, 0.16), -6.0, ("cover4", "parcel", "parcel"))]


def sequences(quick):
    camera = CAMERA.half() if quick else CAMERA
    frames, frames_moved = (QUICK_FRAMES, QUICK_FRAMES) if quick else (FRAMES, FRAMES_MOVED)
    when = (QUICK_MOVED_FROM, QUICK_MOVED_TO) if quick else (MOVED_FROM, MOVED_TO)
    poses = path()
    keys = [{"name": name, "kind": "repeated", "from_frame": 0} for name in ("keyboard", "telephone", "checker floor")]

    def made(name, count, moved):
        objects = [{**o, "to_frame": count - 1} for o in keys]
        if moved:
            objects.append({"name": "carton", "kind": "moved", "from_frame": moved[0], "to_frame": moved[1]})
        return Sequence(
            name, "office.pov", camera, poses[:count], 1, 2, lambda frame: carton(frame, moved), objects=objects
        )

    return [made("office", frames, None), made("office_moved", frames_moved, when)]
