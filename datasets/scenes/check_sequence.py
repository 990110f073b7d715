#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Do pictures, depth, camera.yaml and groundtruth.txt of a rendered sequence belong together, and is the path free?

Carries frames with depth into later ones and compares the grey levels there; a mirrored world must be clearly worse and
an image shifted by half a pixel not better. Tells the depth range; less than 0.2 m means a camera that has run into
something. In frame 0 the centroid of the dark target is compared with the projected one. Both pictures are smoothed by
a pixel, so that it is not noise and aliasing that are compared."""

import argparse
import sys

import cv2
import numpy as np

import reprojection
from sequence_files import SequenceFiles

LIMIT_GREY, LIMIT_WORST_GREY, SMOOTH_PX = 3.0, 4.0, 1.0  # mean of all pairs; worst pair; smoothing of both pictures
LIMIT_CENTROID_PX = 0.25  # an edge along the rows is known to a ray, 2/3 px, but blur blends rows
LEAST_DEPTH_M, MIRRORED_FACTOR, LEAST_SHARE = 0.2, 2.0, 0.15


def pairs(files, count):
    """Frames with depth, spread over the sequence, each with the next frame and every second one with the next that has depth."""
    known = [i for i in range(len(files) - 1) if files.has_depth(i)]
    if len(known) < 2:
        sys.exit(f"{files.folder}: depth of two frames is needed, there is that of {len(known)}")
    starts = np.unique(np.linspace(0, len(known) - 2, count).round().astype(int))
    return [(known[s], known[s] + 1 if n % 2 else known[s + 1]) for n, s in enumerate(starts)]


def smoothed(grey):
    return cv2.GaussianBlur(grey.astype(np.float32), (0, 0), SMOOTH_PX)


def compare(files, i, j):
    """(grey-level differences: right, mirrored, shifted by half a pixel, not carried at all; share; least and largest depth)."""
    a, b = (
        (files.poses[k], smoothed(files.grey(k)), files.depth_m(k) if files.has_depth(k) else None) for k in (i, j)
    )

    def difference(**wrong):
        return reprojection.difference(files.camera, a, b, calm=reprojection.on_one_plane, **wrong)

    value, share = difference()
    return [
        value,
        difference(mirror=-1.0)[0],
        difference(shift_px=0.5)[0],
        np.abs(a[1] - b[1]).mean(),
        share,
        a[2][a[2] > 0].min(),
        a[2].max(),
    ]


def check(folder, count):
    """Prints one line; is the sequence in order?"""
    files = SequenceFiles(folder)
    if any(files.lens()):
        sys.exit(f"{folder}: only pictures without distortion are checked")
    rows = np.array([compare(files, i, j) for i, j in pairs(files, count)])
    right, mean = rows[:, 0], rows.mean(axis=0)
    offset = reprojection.target_offset(files.camera, files.poses[0], files.grey(0))
    good = (
        mean[0] < LIMIT_GREY
        and right.max() < LIMIT_WORST_GREY
        and rows[:, 5].min() > LEAST_DEPTH_M
        and mean[1] > MIRRORED_FACTOR * mean[0]
        and mean[4] > LEAST_SHARE
    )
    good = good and offset is not None and np.abs(offset).max() < LIMIT_CENTROID_PX
    off = "not in view" if offset is None else f"off by ({offset[0]:+.2f}, {offset[1]:+.2f}) px"
    print(
        f"{files.folder.name}: {len(rows)} pairs differ by {mean[0]:.2f} grey levels (limit {LIMIT_GREY:g}; "
        f"worst {right.max():.2f}, limit {LIMIT_WORST_GREY:g}) over {100 * mean[4]:.0f} % of the pixels; mirrored {mean[1]:.1f}, half a pixel off {mean[2]:.2f}, not carried {mean[3]:.1f}; "
        f"depth {rows[:, 5].min():.2f} to {rows[:, 6].max():.2f} m; target {off}{'' if good else '  WRONG'}",
        flush=True,
    )
    return good


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter, prog="render.sh --check"
    )
    parser.add_argument("folder", nargs="+", help="a rendered sequence")
    parser.add_argument(
        "--pairs", type=int, default=8, metavar="N", help="pairs of frames a sequence (default %(default)s)"
    )
    args = parser.parse_args()
    sys.exit(0 if all([check(f, args.pairs) for f in args.folder]) else 1)


if __name__ == "__main__":
    main()
