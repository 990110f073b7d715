#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the tables of datasets/README.md: the sequences, and what a picture costs, measured here and now."""

import argparse
import resource
import tempfile
import time
from pathlib import Path

import cv2
import numpy as np

import animation
import lab
import office
import pictures
import trajectory as tj
from render import save
from render_worlds import sensed


def motion(sequence):
    steps = np.linalg.norm(np.diff(sequence.poses[:, 1:4], axis=0), axis=1)
    interval_s = np.diff(sequence.poses[:2, 0])[0]
    R = [tj.rotation(q) for q in sequence.poses[:, 4:]]
    turned = [np.degrees(np.linalg.norm(cv2.Rodrigues(a.T @ b)[0])) for a, b in zip(R, R[1:])]
    return steps.sum(), steps.mean() / interval_s, sum(turned)


def cost(sequence, depth, count):
    """Core-seconds a picture, our own share and the saving included, and seconds by the clock with nothing beside it."""
    frames = list(np.unique(np.linspace(0, len(sequence.poses) - 1, count).astype(int)))
    with tempfile.TemporaryDirectory() as work:
        work = Path(work)
        pictures.draw(work / "pictures", sequence.scene)

        def spent():
            return sum(
                u.ru_utime + u.ru_stime
                for u in map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
            )

        before, start = spent(), time.monotonic()
        for frame, image in animation.animate(sequence, frames, depth, work / "pictures", work / "run"):
            save(str(work / "out.png"), image) if depth else save(
                str(work / "out.jpg"), sensed(image, sequence, frame, 2.0), qtables=[[8] * 64]
            )
        return (spent() - before) / len(frames), (time.monotonic() - start) / len(frames)


def main():
    parser = argparse.ArgumentParser(description=__doc__, prog="render.sh --describe")
    parser.add_argument(
        "--frames", type=int, default=20, help="frames a sequence to measure the cost with (default %(default)s)"
    )
    args = parser.parse_args()
    print(
        "| sequence | frames | path [m] | mean speed [m/s] | summed rotation [deg] | segments |\n|---|---|---|---|---|---|"
    )
    for s in sorted(lab.sequences(False), key=lambda s: s.name) + office.sequences(False):
        segments = ", ".join(f"{name} {a}–{b}" for name, (a, b) in s.segments.items()) or "-"
        print("| {} | {} | {:.2f} | {:.2f} | {:.0f} | {} |".format(s.name, len(s.poses), *motion(s), segments))
    print("\n| a picture of | grey [core-s] | depth [core-s] | grey, by the clock [s] |\n|---|---|---|---|")
    for s in lab.sequences(False)[:4] + office.sequences(False)[:1]:
        (grey, clock), (depth, _) = (cost(s, d, args.frames) for d in (False, True))
        print(f"| {s.name} | {grey:.2f} | {depth:.2f} | {clock:.2f} |", flush=True)


if __name__ == "__main__":
    main()
