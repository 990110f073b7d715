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

import cv2
import numpy as np

import render
import textures
import trajectory as tj

LIMIT_GREY, LIMIT_PX = 3.0, 0.1  # an edge along the rows is known to a ray, not better: up to 1/6 px
TARGET_W = np.array([[-0.105, -0.07425, 0], [0.105, -0.07425, 0], [0.105, 0.07425, 0], [-0.105, 0.07425, 0]])


def back_project(pose, depth_m, shift_px=0.0, mirror=1.0):
    v, u = np.mgrid[0:render.HEIGHT, 0:render.WIDTH].astype(float)
    rays = np.stack([mirror * (u + shift_px - render.CX) / render.FX, (v + shift_px - render.CY) / render.FY, np.ones_like(u)], -1)
    return (rays * depth_m[..., None]).reshape(-1, 3) @ tj.rotation(pose[4:]).T + pose[1:4]


def smooth_depth(depth_m):
    """Pixels with no depth step within two pixels."""
    kernel = np.ones((5, 5), np.uint8)
    d = depth_m.astype(np.float32)
    return cv2.dilate(d, kernel) - cv2.erode(d, kernel) < 0.02 * d


def difference(a, b, shift_px=0.0, mirror=1.0):
    """(mean |A - B| in grey levels, fraction of A's pixels compared); a, b = (pose, grey, depth)."""
    points = back_project(a[0], a[2], shift_px, mirror)
    z = ((points - b[0][1:4]) @ tj.rotation(b[0][4:])[:, 2]).reshape(a[2].shape)
    uv = render.project(b[0], points).astype(np.float32).reshape(*a[2].shape, 2)
    if mirror < 0:
        uv[..., 0] = 2 * render.CX - uv[..., 0]
    uv -= shift_px
    grey = cv2.remap(b[1].astype(np.float32), uv[..., 0], uv[..., 1], cv2.INTER_CUBIC, borderValue=-1000)
    seen = cv2.remap(b[2].astype(np.float32), uv[..., 0], uv[..., 1], cv2.INTER_LINEAR, borderValue=0)
    calm = cv2.remap(smooth_depth(b[2]).astype(np.float32), uv[..., 0], uv[..., 1], cv2.INTER_LINEAR, borderValue=0)
    use = smooth_depth(a[2]) & (calm > 0.99) & (grey > -100)
    if mirror > 0:
        use &= np.abs(seen - z) < 0.004 * z
    return np.abs(grey - a[1])[use].mean(), use.mean()


def centroid(polygon):
    x, y = polygon.T
    xn, yn = np.roll(polygon, -1, axis=0).T
    cross = x * yn - xn * y
    return np.array([((x + xn) * cross).sum(), ((y + yn) * cross).sum()]) / (3 * cross.sum())


def target_offset(pose, grey):
    """Centroid of the dark target in the image minus that of its projection [px]; None if it is not all in view."""
    outline = render.project(pose, TARGET_W)
    low, high = np.floor(outline.min(0)).astype(int) - 4, np.ceil(outline.max(0)).astype(int) + 5
    if (low < 0).any() or (high > [render.WIDTH, render.HEIGHT]).any():
        return None
    mask = np.zeros(grey.shape, np.uint8)
    cv2.fillPoly(mask, [np.rint(outline).astype(np.int32)], 1)
    mask = cv2.dilate(mask, np.ones((7, 7), np.uint8))
    light = ((grey / 255 + 0.055) / 1.055) ** 2.4  # only linear light is proportional to the covered share of a pixel
    black, white = np.percentile(light[mask > 0], [40, 98])
    dark = np.clip(1.1 * (white - light) / (white - black) - 0.05, 0, 1) * mask  # level paper, level target
    v, u = np.mgrid[0:grey.shape[0], 0:grey.shape[1]]
    return np.array([(dark * u).sum(), (dark * v).sum()]) / dark.sum() - centroid(outline)


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
            value, share = difference(a, b)
            worst = max(worst, value)
            print(f"{pair:>8}: {value:.2f} grey levels over {100 * share:.0f} % of the pixels; mirrored "
                  f"{difference(a, b, mirror=-1.0)[0]:.1f}, half a pixel off {difference(a, b, shift_px=0.5)[0]:.2f}, "
                  f"no correction {np.abs(a[1] - b[1]).mean():.1f}", flush=True)
            offset = target_offset(*a[:2])
            if offset is not None:
                worst_px = max(worst_px, np.abs(offset).max())
                print(f"          target centroid off by ({offset[0]:+.3f}, {offset[1]:+.3f}) px")
    print(f"worst pair: {worst:.2f} grey levels (limit {LIMIT_GREY:g}), worst centroid {worst_px:.3f} px (limit {LIMIT_PX:g})")
    sys.exit(0 if worst < LIMIT_GREY and worst_px < LIMIT_PX else 1)


if __name__ == "__main__":
    main()
