# SPDX-License-Identifier: BSD-3-Clause
"""The twenty laboratory sequences: five each of U-turn and straight line, almost full turn, straight rail, corridor."""

from lab_paths import rail, turn, uturn
from lab_things import Movers, cartons, clutter, person, trolley
from sequence import Box, Camera, Sequence

# A wide-angle webcam's picture at 424 x 240: 65 degrees from left to right.
CAMERA = Camera(424, 240, 330.0, 330.0, 211.5, 119.5)
DEPTH_EVERY = 10

# frames, radius, height, start angle, angle that the eye goes ahead
UTURNS = [
    (660, 1.15, 0.50, -90, 20),
    (720, 1.22, 0.46, -84, 28),
    (600, 1.12, 0.55, -96, 12),
    (780, 1.22, 0.56, -90, 34),
    (640, 1.18, 0.58, -80, -12),
]
# frames, radius, height, start angle, sweep
TURNS = [
    (780, 1.18, 0.50, -90, 342),
    (700, 1.22, 0.46, -84, -338),
    (840, 1.26, 0.55, -98, 348),
    (640, 1.16, 0.52, -92, -330),
    (1050, 1.32, 0.58, -80, 345),
]
# frames, start, end, passes, yaw from and to, pitch from and to
RAILS = [
    (450, (0.35, -1.00, 0.48), (-2.20, -1.15, 0.50), 1, (98, 90), (-24, -20)),
    (480, (0.05, -0.78, 0.46), (0.15, -1.90, 0.62), 2, (90, 90), (-26, -18)),
    (450, (-0.55, -0.90, 0.42), (0.70, -0.95, 0.62), 2, (68, 105), (-22, -26)),
    (520, (0.20, -0.95, 0.55), (-3.00, -1.15, 0.45), 1, (96, 84), (-25, -18)),
    (500, (1.10, -0.45, 0.50), (1.20, 1.70, 0.48), 1, (160, 186), (-22, -18)),
]
# frames, end of the rail in y, yaw at the end, height
CORRIDORS = [
    (450, 4.5, 100, 0.50),
    (480, 5.2, 78, 0.46),
    (500, 6.0, 108, 0.55),
    (460, 4.0, 90, 0.42),
    (520, 6.5, 96, 0.52),
]


def carried(name, frames, quick):
    """Person and trolley where the camera does not come, and the box of the table that is displaced."""
    last = frames - 1
    person_walks = {
        "uturn": ((1.6, -1.9), (-4.2, -2.1), 0.35, 0.95),
        "turn": ((2.1, 2.2), (-2.4, 2.3), 0.08, 0.30),
        "rails": ((1.5, 2.1), (-2.5, 2.0), 0.15, 0.7),
        "corridor": ((1.05, 2.6), (1.0, 11.0), 0.10, 0.95),
    }
    trolley_walks = {
        "uturn": ((-4.6, 2.35), (-2.6, 2.4), 0.05, 0.6),
        "turn": ((-2.4, -2.1), (0.4, -2.1), 0.45, 0.8),
        "rails": ((-3.9, 1.3), (-1.8, 1.2), 0.3, 0.9),
        "corridor": ((1.0, 5.0), (1.02, 8.5), 0.2, 0.9),
    }

    def walk(make, table, deg):
        start, end, first, until = table[name]
        return make, start, end, deg, round(first * last), round(until * last)

    at, where = (0.47, 0.02), (0.16, 0.12, 0.14)
    if name == "corridor":
        at, where = (-0.45, -0.12), (0.12, 0.10, 0.10)
    box = Box((*at, 0.0), where, 12.0, ("label", "parcel", "cover2"))
    return Movers(
        [
            walk(person, person_walks, 90 if name == "corridor" else 5),
            walk(trolley, trolley_walks, 90 if name == "corridor" else 0),
        ],
        box,
        (0.05, 0.035, 0.0),
        round((0.2 if name != "corridor" else 0.08) * last),
    )


def sequence(kind, k, path, quick):
    poses, segments = path
    frames = len(poses)
    movers = carried(kind, frames, quick)
    objects = movers.marks() + [
        {"name": n, "kind": what, "from_frame": 0, "to_frame": frames - 1}
        for n, what in [
            ("wires before edges", "crossing_edges"),
            ("doors" if kind == "corridor" else "screens, keys and folders", "repeated"),
            ("checker floor", "repeated"),
        ]
    ]
    still = cartons(k) if kind == "corridor" else clutter(k)
    return Sequence(
        f"lab_{kind}_{k}",
        "corridor.pov" if kind == "corridor" else "lab.pov",
        CAMERA.half() if quick else CAMERA,
        poses,
        DEPTH_EVERY,
        2.5 if quick else 1.5,
        movers,
        still,
        segments,
        objects,
    )


def corridor(frames, end_y, yaw_end_deg, height, seed):
    return rail(frames, (0.48, -0.95, height), (0.52, end_y, height), 1, (118, yaw_end_deg), (-24, -8), seed)


def sequences(quick):
    """In the order in which they are rendered: the first of each kind, then the second, ..."""
    if quick:
        return [
            sequence("uturn", 1, uturn(90, 0.9, 0.80, 5, 20, 1), True),
            sequence("turn", 1, turn(90, 0.9, 0.80, -90, 120, 1), True),
        ]
    out = []
    for i in range(5):
        out += [
            sequence("uturn", i + 1, uturn(*UTURNS[i], i + 1), False),
            sequence("turn", i + 1, turn(*TURNS[i], i + 1), False),
            sequence("rails", i + 1, rail(*RAILS[i], i + 1), False),
            sequence("corridor", i + 1, corridor(*CORRIDORS[i], i + 1), False),
        ]
    return out
