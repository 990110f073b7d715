# SPDX-License-Identifier: BSD-3-Clause
"""Does a frame, carried into another one by its depth and the two poses, show there what the other one shows?"""

import cv2
import numpy as np

import trajectory as tj

TARGET_W = np.array([[-0.105, -0.07425, 0], [0.105, -0.07425, 0], [0.105, 0.07425, 0], [-0.105, 0.07425, 0]])
PAPER_M = 0.297, 0.21


def back_project(camera, pose, depth_m, shift_px=0.0, mirror=1.0):
    v, u = np.mgrid[0 : camera.height, 0 : camera.width].astype(float)
    rays = np.stack(
        [mirror * (u + shift_px - camera.cx) / camera.fx, (v + shift_px - camera.cy) / camera.fy, np.ones_like(u)], -1
    )
    return (rays * depth_m[..., None]).reshape(-1, 3) @ tj.rotation(pose[4:]).T + pose[1:4]


def smooth_depth(depth_m):
    """Pixels with no depth step within two pixels."""
    kernel = np.ones((5, 5), np.uint8)
    d = depth_m.astype(np.float32)
    return cv2.dilate(d, kernel) - cv2.erode(d, kernel) < 0.02 * d


def on_one_plane(depth_m):
    """Pixels whose neighbourhood is one plane, however steep: there 1/z is linear in the picture."""
    inverse = 1 / np.maximum(depth_m, 1e-3).astype(np.float32)
    bent = np.abs(inverse - cv2.blur(inverse, (5, 5))) > 0.002 * inverse
    return cv2.dilate(bent.astype(np.uint8), np.ones((3, 3), np.uint8)) == 0


def difference(camera, a, b, shift_px=0.0, mirror=1.0, calm=smooth_depth):
    """(mean |A - B| in grey levels, fraction of A's pixels compared); a, b = (pose, grey, depth).

    Without depth of B (None) nothing says what is hidden there: for neighbours only."""
    points = back_project(camera, a[0], a[2], shift_px, mirror)
    z = ((points - b[0][1:4]) @ tj.rotation(b[0][4:])[:, 2]).reshape(a[2].shape)
    uv = camera.project(b[0], points).astype(np.float32).reshape(*a[2].shape, 2)
    if mirror < 0:
        uv[..., 0] = 2 * camera.cx - uv[..., 0]
    uv -= shift_px
    grey = cv2.remap(b[1].astype(np.float32), uv[..., 0], uv[..., 1], cv2.INTER_CUBIC, borderValue=-1000)
    use = calm(a[2]) & (grey > -100)
    if b[2] is not None:
        seen = cv2.remap(b[2].astype(np.float32), uv[..., 0], uv[..., 1], cv2.INTER_LINEAR, borderValue=0)
        use &= cv2.remap(calm(b[2]).astype(np.float32), uv[..., 0], uv[..., 1], cv2.INTER_LINEAR, borderValue=0) > 0.99
        if mirror > 0:
            use &= np.abs(seen - z) < 0.004 * z
    return np.abs(grey - a[1])[use].mean(), use.mean()


def centroid(polygon):
    x, y = polygon.T
    xn, yn = np.roll(polygon, -1, axis=0).T
    cross = x * yn - xn * y
    return np.array([((x + xn) * cross).sum(), ((y + yn) * cross).sum()]) / (3 * cross.sum())


def target_offset(camera, pose, grey):
    """Centroid of the dark target in the image minus that of its projection [px]; None if it is not all in view."""
    outline, paper = (
        camera.project(pose, TARGET_W),
        camera.project(pose, TARGET_W * [PAPER_M[0] / 0.21, PAPER_M[1] / 0.1485, 0]),
    )
    if (paper.min(0) < 0).any() or (paper.max(0) > [camera.width - 1, camera.height - 1]).any():
        return None
    mask, sheet = np.zeros(grey.shape, np.uint8), np.zeros(grey.shape, np.uint8)
    cv2.fillPoly(mask, [np.rint(outline).astype(np.int32)], 1)
    cv2.fillPoly(sheet, [np.rint(paper).astype(np.int32)], 1)
    mask = cv2.dilate(mask, np.ones((7, 7), np.uint8)) & cv2.erode(
        sheet, np.ones((3, 3), np.uint8)
    )  # nothing beyond the paper
    light = ((grey / 255 + 0.055) / 1.055) ** 2.4  # only linear light is proportional to the covered share of a pixel
    black, white = np.percentile(light[mask > 0], [40, 98])
    dark = np.clip(1.1 * (white - light) / (white - black) - 0.05, 0, 1) * mask  # level paper, level target
    v, u = np.mgrid[0 : grey.shape[0], 0 : grey.shape[1]]
    return np.array([(dark * u).sum(), (dark * v).sum()]) / dark.sum() - centroid(outline)
