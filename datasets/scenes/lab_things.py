# SPDX-License-Identifier: BSD-3-Clause
"""What stands and moves in the laboratory and its corridor: clutter by a seed, a person, a trolley, a displaced box."""

import numpy as np

from sequence import Box, ease

SKINS = [
    "cover0",
    "cover1",
    "cover2",
    "cover3",
    "cover4",
    "cover5",
    "carton",
    "label",
    "page0",
    "page1",
    "parcel",
    "mug0",
]
TARGET_MARGIN_M = (0.20, 0.16)  # kept free round the target
MOVED_FRAMES = 8
TABLE_KEPT = [(-0.36, 0.10, 0.17, 0.09), (-0.42, 0.52, 0.26, 0.12), (0.03, 0.54, 0.2, 0.14), (0.47, 0.02, 0.2, 0.14)]


def scattered(rng, area, count, tallest, kept):
    """Boxes on the area (x0, y0, x1, y1) that overlap neither each other nor what is kept free (x, y, half sizes).
    Near the target they are low, so that it shows from the south, and tall ones stand apart from it."""
    boxes, taken = [], list(kept)
    for _ in range(60 * count):
        size = rng.uniform([0.05, 0.05, 0.02], [0.20, 0.18, 1.0])
        x, y = rng.uniform(area[:2], area[2:])
        half = 0.5 * np.hypot(size[0], size[1]) + 0.01
        if len(boxes) == count:
            break
        if x - half < area[0] or x + half > area[2] or y - half < area[1] or y + half > area[3]:
            continue
        if any(abs(x - kx) < half + kw and abs(y - ky) < half + kh for kx, ky, kw, kh in taken):
            continue
        size[2] = max(0.02, size[2] * min(tallest, 0.33 * (np.hypot(x, y) - half)))
        boxes.append(Box((x, y, 0.0), tuple(size), rng.uniform(-40, 40), tuple(rng.choice(SKINS, 3))))
        taken.append((x, y, half, half))
    return boxes


def clutter(seed):
    rng = np.random.default_rng([77, seed])
    target = (0, 0, *TARGET_MARGIN_M)
    bench = [(-4.2 + 0.85 * i, -0.15, 0.24, 0.10) for i in range(3)] + [
        (-4.0 + 0.85 * i, 0.10, 0.14, 0.1) for i in range(3)
    ]
    return scattered(rng, (-0.79, -0.27, 0.79, 0.71), 26, 0.24, [target] + TABLE_KEPT) + scattered(
        rng, (-4.6, -0.49, -1.8, 0.39), 34, 0.28, bench
    )


def cartons(seed):
    """Along both walls of the corridor, standing on its floor."""
    rng = np.random.default_rng([78, seed])
    boxes, free = [], {-1: 0.9, 1: -1.0}
    for side in (-1, 1):
        y = free[side]
        while y < 12.5:
            size = rng.uniform([0.16, 0.2, 0.2], [0.28, 0.6, 0.95])
            x = -0.6 + size[0] / 2 + 0.005 if side < 0 else 1.35 - size[0] / 2 - 0.005
            boxes.append(Box((x, y + size[1] / 2, -0.75), tuple(size), 0.0, tuple(rng.choice(SKINS, 3))))
            y += size[1] + rng.uniform(0.05, 0.9)
    return [b for b in boxes if not any(abs(b.centre[1] - (3.3 + 4 * i)) < 0.45 and b.centre[0] < 0 for i in range(3))]


def person(x, y, deg):
    coat, other = ("coat", "coat", "coat"), ("grain", "grain", "grain")
    return [
        Box((x, y, -0.75), (0.34, 0.20, 0.80), deg, other),
        Box((x, y, 0.05), (0.44, 0.24, 0.60), deg, coat),
        Box((x, y, 0.68), (0.19, 0.20, 0.25), deg, ("mug1", "mug1", "mug1")),
    ]


def trolley(x, y, deg):
    return [
        Box((x, y, -0.65), (0.7, 0.45, 0.06), deg, ("grain", "grain", "grain")),
        Box((x, y, -0.59), (0.5, 0.40, 0.45), deg, ("parcel", "carton", "parcel")),
        Box((x, y, -0.14), (0.3, 0.25, 0.22), deg, ("cover3", "label", "cover5")),
    ]


def along(start, end, first, last, frame):
    """Where somebody is who goes from start to end within the frames and stands before and after."""
    return np.array(start) + float(ease((frame - first) / (last - first))) * np.subtract(end, start)


class Movers:
    """The moving boxes of a sequence: walks of (make, start, end, deg, first, last) and one displaced box."""

    def __init__(self, walks, box, shift, moved_at):
        self.walks, self.box, self.shift, self.moved_at = walks, box, np.array(shift), moved_at

    def __call__(self, frame):
        boxes = [
            b
            for make, start, end, deg, first, last in self.walks
            for b in make(*along(start, end, first, last, frame), deg)
        ]
        share = float(ease((frame - self.moved_at) / MOVED_FRAMES))
        centre = tuple(np.array(self.box.centre) + share * self.shift)
        return boxes + [Box(centre, self.box.size, self.box.deg, self.box.pictures)]

    def marks(self):
        return [
            {"name": make.__name__, "kind": "moving", "from_frame": first, "to_frame": last}
            for make, _, _, _, first, last in self.walks
        ] + [
            {
                "name": "displaced box",
                "kind": "moved",
                "from_frame": self.moved_at,
                "to_frame": self.moved_at + MOVED_FRAMES,
            }
        ]
