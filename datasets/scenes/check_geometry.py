#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Does groundtruth.txt describe the camera that took the pictures?

Renders pairs of frames without noise, carries every pixel of A into B with the depth of A and the two poses, and
compares the grey levels where B sees the same point. Then does the same with wrong conventions (mirrored world,
image shifted by half a pixel), which must be worse. A common shift of all images hardly shows there, so the centroid
of the dark target is compared with the projected one as well. Fails at 3 grey levels or 0.1 px."""
import argparse
import os
import sys
import tempfile

import numpy as np

import render
import reprojection
import textures
import trajectory as tj
from sequence import Camera

CAMERA = Camera(render.WIDTH, render.HEIGHT, render.FX, render.FY, render.CX, render.CY)
LIMIT_GREY, LIMIT_PX = 3.0, 0.1  # an edge along the rows is known to a ray, not better: up to 1/6 px


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pairs", nargs="+", default=["0:1", "40:42", "100:105", "150:160", "0:60", "70:85", "239:0"])
    args = parser.parse_args()
    rows, worst, worst_px = tj.poses("desk"), 0.0, 0.0
    with tempfile.TemporaryDirectory() as work:
        pictures = os.path.join(work, "pictures")
        textures.draw(pictures)

        def frame(i):
            return (rows[i], render.clean_grey("desk", i, pictures, work),
                    render.depth_image("desk", i, pictures, work) * render.DEPTH_UNIT_M)
        for pair in args.pairs:
            a, b = (frame(int(i)) for i in pair.split(":"))
            value, share = reprojection.difference(CAMERA, a, b)
            worst = max(worst, value)
            print(f"{pair:>8}: {value:.2f} grey levels over {100 * share:.0f} % of the pixels; mirrored "
                  f"{reprojection.difference(CAMERA, a, b, mirror=-1.0)[0]:.1f}, half a pixel off {reprojection.difference(CAMERA, a, b, shift_px=0.5)[0]:.2f}, "
                  f"no correction {np.abs(a[1] - b[1]).mean():.1f}", flush=True)
            offset = reprojection.target_offset(CAMERA, *a[:2])
            if offset is not None:
                worst_px = max(worst_px, np.abs(offset).max())
                print(f"          target centroid off by ({offset[0]:+.3f}, {offset[1]:+.3f}) px")
    print(f"worst pair: {worst:.2f} grey levels (limit {LIMIT_GREY:g}), worst centroid {worst_px:.3f} px (limit {LIMIT_PX:g})")
    sys.exit(0 if worst < LIMIT_GREY and worst_px < LIMIT_PX else 1)


if __name__ == "__main__":
    main()
