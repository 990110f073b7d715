# SPDX-License-Identifier: BSD-3-Clause
"""Hand-held-like camera paths over the desk: two slow loops and the tremor of a hand, all sinusoids."""
import math

import numpy as np

RATE_HZ = 30.0
FRAMES = {"desk": 240, "desk_moving": 120}
BOX_START_X_M, BOX_SPEED_MPS, BOX_STARTS_AT_FRAME = 0.47, 0.13, 30
BOX_SIZE_M, BOX_Y_M = (0.34, 0.14, 0.28), 0.20


def tremor(rng, t, size, hz):
    """Sum of sinusoids at about `hz` with random phase, one column an axis; starts at zero."""
    out = np.zeros((len(t), 3))
    for axis in range(3):
        for harmonic in (0.6, 1.0, 1.7):
            w, phase = 2 * math.pi * hz * harmonic * rng.uniform(0.85, 1.15), rng.uniform(0, 2 * math.pi)
            out[:, axis] += size / harmonic ** 1.5 * (np.sin(w * t + phase) - math.sin(phase))
    return out * np.minimum(1, t / 0.7)[:, None] ** 2


def loop_phase(n, loops):
    """Runs from 0 to 2 pi `loops` at a constant rate but for an eased start and end."""
    ease = np.minimum(1, np.minimum(np.arange(n), np.arange(n)[::-1]) / 24.0)
    speed = 0.5 - 0.5 * np.cos(math.pi * ease)
    phase = np.concatenate([[0], np.cumsum(0.5 * (speed[1:] + speed[:-1]))])
    return 2 * math.pi * loops * phase / phase[-1]


def look_at(position, target, roll):
    """R_wc of a camera (x right, y down, z forward) that looks at `target`, then rolls about z."""
    z = (target - position) / np.linalg.norm(target - position)
    x = np.cross(z, [0, 0, 1.0])
    x /= np.linalg.norm(x)
    y = np.cross(z, x)
    c, s = math.cos(roll), math.sin(roll)
    return np.column_stack([c * x + s * y, -s * x + c * y, z])


def quaternion(R):
    """x y z w of a rotation matrix (w > 0: no pose of ours turns by pi)."""
    w = 0.5 * math.sqrt(max(0.0, 1 + np.trace(R)))
    if w < 1e-3:
        raise ValueError("half turn")
    return np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1], 4 * w * w]) / (4 * w)


def rotation(q):
    x, y, z, w = q / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def poses(name):
    """Rows `t tx ty tz qx qy qz qw` of T_wc, rounded as they are written."""
    n = FRAMES[name]
    t = np.arange(n) / RATE_HZ
    if name == "desk":
        rng, a = np.random.default_rng(11), loop_phase(n, 2)
        centre = np.column_stack([0.27 * np.sin(a), -0.58 + 0.09 * np.sin(2 * a), 0.56 + 0.10 * np.sin(0.5 * a)])
        target = np.column_stack([-0.13 * np.sin(a + 0.5) + 0.06, 0.13 + 0.07 * np.sin(a), np.full(n, 0.03)])
        roll = 0.10 * np.sin(0.5 * a) - 0.05 * np.sin(1.5 * a)
    else:
        rng, a = np.random.default_rng(23), loop_phase(n, 1)
        centre = np.column_stack([-0.24 * np.sin(a), -0.60 + 0.06 * np.sin(2 * a), 0.58 + 0.05 * (1 - np.cos(a))])
        target = np.column_stack([0.08 * np.sin(a + 0.4) + 0.05, 0.14 + 0.05 * np.sin(a), np.full(n, 0.03)])
        roll = -0.07 * np.sin(a)
    centre += tremor(rng, t, 0.0022, 2.0)
    target += tremor(rng, t, 0.0035, 2.4)
    rows = [np.concatenate([[(i + 1) / RATE_HZ], centre[i], quaternion(look_at(centre[i], target[i], roll[i]))]) for i in range(n)]
    return np.array([[float(f"{v:.9f}") for v in row] for row in rows])


def box_x(name, frame):
    """x [m] of the sliding box; it speeds up within half a second."""
    if name != "desk_moving":
        return BOX_START_X_M
    t = max(0.0, (frame - BOX_STARTS_AT_FRAME) / RATE_HZ)
    moved = BOX_SPEED_MPS * (t * t if t < 0.5 else t - 0.25)
    return BOX_START_X_M - moved


def box_corners(x):
    """The eight corners of the sliding box in the world [m]."""
    w, d, h = BOX_SIZE_M
    return np.array([[x + sx * w / 2, BOX_Y_M + sy * d / 2, z] for sx in (-1, 1) for sy in (-1, 1) for z in (0, h)])
