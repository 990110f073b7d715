# SPDX-License-Identifier: BSD-3-Clause
"""What describes one rendered sequence, whatever its world."""

import math
from dataclasses import dataclass, field
from typing import Callable

import cv2
import numpy as np

import trajectory as tj

# Scenes have their table tops at z = 0, the target this much above them; the world's origin is on the target.
TARGET_LIFT_M = 0.001


@dataclass(frozen=True)
class Camera:
    width: int
    height: int
    fx: float
    fy: float
    cx: float
    cy: float

    def half(self):
        """The camera of half the size that sees the same; integer coordinates are pixel centres in both."""
        return Camera(
            self.width // 2, self.height // 2, self.fx / 2, self.fy / 2, (self.cx - 0.5) / 2, (self.cy - 0.5) / 2
        )

    def project(self, pose, points_w):
        p = (points_w - pose[1:4]) @ tj.rotation(pose[4:])
        return np.column_stack([self.fx * p[:, 0] / p[:, 2] + self.cx, self.fy * p[:, 1] / p[:, 2] + self.cy])


@dataclass(frozen=True)
class Box:
    """A box that stands on the middle of its base, turned by `deg` about z; the pictures of its top, front and side."""

    centre: tuple
    size: tuple
    deg: float
    pictures: tuple

    def scene_line(self):
        triple = "<{:.9g}, {:.9g}, {:.9g}>"
        skins = ", ".join("Skin_" + p for p in self.pictures)
        return f"Block({triple.format(*self.centre)}, {triple.format(*self.size)}, {self.deg:.9g}, {skins})"

    def holds(self, point, margin_m):
        """Is the point inside the box or within the margin of it?"""
        a = math.radians(self.deg)
        d = np.asarray(point, float) - self.centre
        local = np.array([math.cos(a) * d[0] + math.sin(a) * d[1], -math.sin(a) * d[0] + math.cos(a) * d[1]])
        return bool(
            (np.abs(local) < np.array(self.size[:2]) / 2 + margin_m).all()
            and -margin_m < d[2] < self.size[2] + margin_m
        )


@dataclass(frozen=True)
class Sequence:
    name: str
    scene: str  # the .pov file
    camera: Camera
    poses: np.ndarray  # rows t tx ty tz qx qy qz qw, rounded as they are written
    depth_every: int
    rays_per_side: float  # of a pixel; their mean is the anti-aliasing
    moving: Callable = lambda frame: []  # the boxes that move, as they stand in a frame
    still: list = field(default_factory=list)  # boxes of this sequence that never move
    segments: dict = field(default_factory=dict)  # name -> [first frame, last frame]
    objects: list = field(default_factory=list)  # what is there to be wrong about: name, kind, from_frame, to_frame


def look_along(yaw, pitch, roll):
    """R_wc of a camera that looks along the yaw (about z, 0 = +x), pitched up by `pitch`, then rolled about its axis."""
    direction = np.array([math.cos(pitch) * math.cos(yaw), math.cos(pitch) * math.sin(yaw), math.sin(pitch)])
    return tj.look_at(np.zeros(3), direction, roll)


def quaternion(R):
    """x y z w of any rotation, w >= 0 (trajectory.quaternion has no half turns)."""
    vector = cv2.Rodrigues(R)[0].ravel()
    angle = np.linalg.norm(vector)
    if angle < 1e-12:
        return np.array([0, 0, 0, 1.0])
    return np.append(vector / angle * math.sin(angle / 2), math.cos(angle / 2))


def pose_rows(rate_hz, centres, rotations):
    """Poses in the world, from positions in the scene; rounded as they are written, before anything is rendered."""
    lift = [0, 0, TARGET_LIFT_M]
    rows = np.array(
        [[(i + 1) / rate_hz, *(c - lift), *quaternion(R)] for i, (c, R) in enumerate(zip(centres, rotations))]
    )
    return np.array([[float(f"{v:.9f}") for v in row] for row in rows])


def ease(x):
    """0 before 0, 1 after 1, smooth in between."""
    x = np.clip(x, 0, 1)
    return x * x * x * (10 + x * (6 * x - 15))
