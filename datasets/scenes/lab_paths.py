# SPDX-License-Identifier: BSD-3-Clause
"""The laboratory's camera paths, slow as on a rail: each returns the poses and its segments (first and last frame)."""

import math

import cv2
import numpy as np

from sequence import ease, look_along, pose_rows

RATE_HZ = 15.0
TABLE = np.array([0.0, 0.22])  # the middle of the cluttered table
STRAIGHT_M = 3.0
EASE_FRAMES = 15


def advance(frames, sway, phase):
    """0 to 1 at a nearly constant rate: eased in at the start, faster and slower by the share `sway` afterwards."""
    i = np.arange(frames)
    rate = ease((i + 0.5) / EASE_FRAMES) * (1 + sway * np.sin(2 * math.pi * i / 170 + phase) * np.minimum(1, i / 60))
    s = np.concatenate([[0], np.cumsum(rate[:-1])])
    return s / s[-1]


def wobble(frames, phase, size_rad):
    """Yaw, pitch and roll of a carriage that does not run quite true."""
    t = np.arange(frames)[:, None] / RATE_HZ
    return (
        size_rad
        * np.sin(2 * math.pi * t * np.array([0.31, 0.43, 0.22]) + phase * np.array([1, 2, 3]))
        * np.minimum(1, t)
    )


def smoothed(angle):
    """No step in the rate of a turn: Gaussian over half a second, continued beyond both ends."""
    n = 24
    lead, tail = (
        angle[0] + (angle[1] - angle[0]) * np.arange(-n, 0),
        angle[-1] + (angle[-1] - angle[-2]) * np.arange(1, n + 1),
    )
    padded = np.concatenate([lead, angle, tail]).astype(np.float64)
    return cv2.GaussianBlur(padded[:, None], (1, 2 * n + 1), sigmaX=1, sigmaY=7.0).ravel()[n:-n]


def rows(centres, yaw, pitch, shake):
    yaw, pitch, roll = yaw + shake[:, 0], pitch + shake[:, 1], shake[:, 2]
    return pose_rows(RATE_HZ, centres, [look_along(*angles) for angles in zip(yaw, pitch, roll)])


def circle(phi, radius, height):
    return np.column_stack([TABLE[0] + radius * np.cos(phi), TABLE[1] + radius * np.sin(phi), height])


def turn(frames, radius, height, start_deg, sweep_deg, seed):
    """Almost a full turn round the table, looking at it."""
    phi = np.radians(start_deg + sweep_deg * advance(frames, 0.15, seed))
    swing = phi - phi[0]
    centres = circle(phi, radius + 0.05 * np.sin(2 * swing), height + 0.04 * np.sin(1.5 * swing))
    pitch = -np.arctan2(height + 0.02, radius) + 0.02 * np.sin(2 * swing)
    return rows(centres, phi + math.pi, pitch, wobble(frames, seed, 0.012)), {"turn": [0, frames - 1]}


def uturn(frames, radius, height, start_deg, ahead_deg, seed):
    """A U-turn round the table, then a straight line of exactly STRAIGHT_M; the eye goes ahead by ahead_deg there."""
    arc = radius * math.radians(90 - start_deg)
    turning = round((frames - 1 - EASE_FRAMES / 2) * arc / (arc + STRAIGHT_M) + EASE_FRAMES / 2)
    phi = np.radians(start_deg + (90 - start_deg) * advance(turning + 1, 0.0, 0))
    way = np.linspace(0, 1, frames - turning)
    bend = circle(phi, radius, np.full(len(phi), height))
    line = bend[-1] + np.outer(way, [-STRAIGHT_M, 0, 0])
    yaw = np.concatenate([phi + math.pi, np.full(len(way) - 1, 1.5 * math.pi)])
    ahead = math.radians(ahead_deg) * ease((np.arange(frames) - turning) / 60)
    down = -math.atan2(height + 0.02, radius)
    pitch = down + (max(down + 0.05, -0.5) - down) * ease((np.arange(frames) - turning) / 60)
    poses = rows(np.vstack([bend, line[1:]]), smoothed(yaw) - ahead, pitch, wobble(frames, seed, 0.008))
    return poses, {"turn": [0, turning], "straight": [turning, frames - 1]}


def rail(frames, start, end, passes, yaw_deg, pitch_deg, seed):
    """Along one straight rail, there and back as often as `passes` says; yaw and pitch go from the first value to the second."""
    s = advance(frames, 0.1, seed)
    where = 0.5 - 0.5 * np.cos(math.pi * passes * s) if passes > 1 else s
    centres = np.array(start) + np.outer(where, np.subtract(end, start))
    yaw, pitch = (np.radians(a + (b - a) * ease(1.3 * where)) for a, b in (yaw_deg, pitch_deg))
    return rows(centres, yaw, pitch, wobble(frames, seed, 0.008)), {"straight": [0, frames - 1]} if passes == 1 else {}
