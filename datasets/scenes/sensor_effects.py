# SPDX-License-Identifier: BSD-3-Clause
"""What a cheap camera does to a picture, each as one function. Light is linear here: 0 to 1, not grey levels."""

import cv2
import numpy as np

import trajectory as tj
from reprojection import back_project
from render import srgb
from sequence import Camera, quaternion

MOST_EXPOSURE_SAMPLES = 15


def linear_light(grey):
    s = grey.astype(np.float32) / 255
    return np.where(s <= 0.04045, s / 12.92, ((s + 0.055) / 1.055) ** 2.4).astype(np.float32)


def grey_levels(light):
    return srgb(np.clip(light, 0, 1))


# ---- lens ------------------------------------------------------------------------------------------
def ideal_pixels(source, camera, lens):
    """Where each pixel of the camera with that lens (k1, k2) looks in the picture of the ideal one, h x w x 2 [px]."""
    v, u = np.mgrid[0 : camera.height, 0 : camera.width].astype(np.float64)
    pixels = np.stack([u, v], -1).reshape(-1, 1, 2)
    K = np.array([[camera.fx, 0, camera.cx], [0, camera.fy, camera.cy], [0, 0, 1]])
    criteria = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 60, 1e-9)
    rays = cv2.undistortPointsIter(pixels, K, np.array([*lens, 0, 0]), None, None, criteria).reshape(
        camera.height, camera.width, 2
    )
    return rays * [source.fx, source.fy] + [source.cx, source.cy]


def distorted_camera(source, lens):
    """The camera with that lens whose whole picture lies inside the source's: a barrel lens needs a longer focal length."""

    def lacks(scale):
        camera = Camera(source.width, source.height, source.fx * scale, source.fy * scale, source.cx, source.cy)
        at = ideal_pixels(source, camera, lens)
        return at.min() < -0.01 or (at > np.array([source.width - 0.99, source.height - 0.99])).any()

    low, high = 1.0, 1.0
    while lacks(high):
        high *= 1.1
        if high > 4:
            raise ValueError(
                "the lens bends too much: no focal length up to 4 times the source's shows only what is there"
            )
    for _ in range(20 if high > 1 else 0):
        middle = (low + high) / 2
        low, high = (middle, high) if lacks(middle) else (low, middle)
    return Camera(source.width, source.height, source.fx * high, source.fy * high, source.cx, source.cy)


# ---- motion within a frame -------------------------------------------------------------------------
def pose_at(poses, i, share):
    """The pose `share` of a frame after frame i (before it, if negative): straight on, turning evenly."""
    step = 1 if (share >= 0 and i + 1 < len(poses)) or i == 0 else -1
    a, b = poses[i], poses[i + step]
    Ra, Rb = tj.rotation(a[4:]), tj.rotation(b[4:])
    part = share * step
    turned = Ra @ cv2.Rodrigues(cv2.Rodrigues(Ra.T @ Rb)[0] * part)[0]
    return np.concatenate([[a[0]], a[1:4] + part * (b[1:4] - a[1:4]), quaternion(turned)])


def flow_by_depth(camera, poses, i, depth_m, share):
    """Motion of the resting world's pixels in `share` of a frame [px]; where there is no depth, as at infinity."""
    depth = np.where(depth_m > 0, depth_m, 1e4)
    moved = camera.project(pose_at(poses, i, share), back_project(camera, poses[i], depth))
    v, u = np.mgrid[0 : camera.height, 0 : camera.width]
    return (moved.reshape(camera.height, camera.width, 2) - np.stack([u, v], -1)).astype(np.float32)


def flow_by_images(grey, other):
    return cv2.DISOpticalFlow_create(cv2.DISOPTICAL_FLOW_PRESET_MEDIUM).calc(grey, other, None)


class Motion:
    """Pixel motion about a frame's time: by depth and poses, or by the optical flow to its neighbours."""

    def __init__(self, files, i):
        self.files, self.i, n = files, i, len(files)
        self.depth = files.depth_m(i) if files.has_depth(i) else None
        if self.depth is None:
            grey = files.grey(i)
            after = flow_by_images(grey, files.grey(i + 1)) if i + 1 < n else None
            before = flow_by_images(grey, files.grey(i - 1)) if i > 0 else None
            self.after = after if after is not None else -before
            self.before = before if before is not None else -after

    def flow(self, share):
        """[px] in `share` of a frame."""
        if self.depth is not None:
            return flow_by_depth(self.files.camera, self.files.poses, self.i, self.depth, share)
        return share * self.after if share >= 0 else -share * self.before


def frame_interval(files, i):
    j = i + 1 if i + 1 < len(files) else i - 1
    return abs(float(files.stamps[j]) - float(files.stamps[i]))


def source_pixels(at, motion, share_first, share_last):
    """Where each pixel's light comes from in the frame's own picture, if its first row is taken `share_first` of a frame
    after it and the last row `share_last`: u with u + flow(u) = at."""
    first, last = motion.flow(share_first), motion.flow(share_last)
    rows = np.linspace(0, 1, at.shape[0], dtype=np.float32)[:, None, None]
    u = at.astype(np.float32)
    for _ in range(3):

        def sampled(flow):
            return np.dstack(
                [
                    cv2.remap(flow[..., k], u[..., 0], u[..., 1], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
                    for k in (0, 1)
                ]
            )

        u = at.astype(np.float32) - ((1 - rows) * sampled(first) + rows * sampled(last))
    return u


def exposed(light, at, motion, readout, exposure):
    """The picture of a shutter that rolls in `readout` and stays open for `exposure`, both in frames, about the frame's time.

    Also the source pixel of the middle of the exposure."""
    height = at.shape[0]
    first, last = -0.5 * readout, ((height - 1) / height - 0.5) * readout
    middle = source_pixels(at, motion, first, last) if readout else at.astype(np.float32)
    count = 1
    if exposure:
        longest = np.percentile(np.linalg.norm(motion.flow(exposure), axis=-1), 99)
        count = int(np.clip(np.ceil(longest), 2, MOST_EXPOSURE_SAMPLES))
    total = np.zeros(at.shape[:2], np.float32)
    for k in range(count):
        shift = ((k + 0.5) / count - 0.5) * exposure
        u = source_pixels(at, motion, first + shift, last + shift) if exposure else middle
        total += cv2.remap(light, u[..., 0], u[..., 1], cv2.INTER_CUBIC, borderMode=cv2.BORDER_REPLICATE)
    return total / count, middle


# ---- light and electronics ---------------------------------------------------------------------------
def vignetting(camera, loss):
    """Share of the light that is left, falling with the square of the distance from the middle to 1 - loss in the corners."""
    v, u = np.mgrid[0 : camera.height, 0 : camera.width].astype(np.float32)
    r2 = (u - (camera.width - 1) / 2) ** 2 + (v - (camera.height - 1) / 2) ** 2
    return 1 - loss * r2 / r2.max()


def wandering_gain(stamps, spread, seed):
    """Gains whose logarithm wanders with the standard deviation `spread` and forgets within a second."""
    rng, values = np.random.default_rng([1, seed]), []
    t = np.array(stamps, float)
    for i in range(len(t)):
        keep = np.exp(-(t[i] - t[i - 1])) if i else 0.0
        values.append((keep * values[-1] if i else 0.0) + spread * np.sqrt(1 - keep * keep) * rng.standard_normal())
    return np.exp(values)


def read_noise(shape, sigma_grey, seed, frame):
    return np.random.default_rng([2, seed, frame]).normal(0, sigma_grey, shape) if sigma_grey else 0.0
