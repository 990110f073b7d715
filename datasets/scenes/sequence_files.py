# SPDX-License-Identifier: BSD-3-Clause
"""Reads a sequence folder: camera.yaml, groundtruth.txt, rgb.txt, pictures and depth."""

import sys
from pathlib import Path

import cv2
import numpy as np

from sequence import Camera

DEPTH_UNIT_M = 1 / 5000.0
LENS = ("k1", "k2", "p1", "p2", "k3")


def read_yaml(path):
    """The flat `key: number` of camera.yaml."""
    values = {}
    for number, line in enumerate(path.read_text().splitlines(), 1):
        text = line.split("#")[0].strip()
        if not text:
            continue
        key, _, value = text.partition(":")
        try:
            values[key.strip()] = float(value)
        except ValueError:
            sys.exit(f"{path}:{number}: not a number: {text}")
    missing = [k for k in ("width", "height", "fx", "fy", "cx", "cy") if k not in values]
    if missing:
        sys.exit(f"{path}: {missing[0]} is missing")
    return values


class SequenceFiles:
    def __init__(self, folder):
        self.folder = Path(folder)
        for name in ("camera.yaml", "groundtruth.txt", "rgb.txt"):
            if not (self.folder / name).is_file():
                sys.exit(f"{self.folder}: no {name}")
        self.yaml = read_yaml(self.folder / "camera.yaml")
        self.camera = Camera(
            int(self.yaml["width"]), int(self.yaml["height"]), *(self.yaml[k] for k in ("fx", "fy", "cx", "cy"))
        )
        self.poses = np.loadtxt(self.folder / "groundtruth.txt", ndmin=2)
        lines = [x.split() for x in (self.folder / "rgb.txt").read_text().splitlines() if x and not x.startswith("#")]
        self.stamps, self.pictures = [x[0] for x in lines], [x[1] for x in lines]
        if len(self.poses) != len(self.pictures):
            sys.exit(
                f"{self.folder}: {len(self.pictures)} pictures in rgb.txt, {len(self.poses)} poses in groundtruth.txt"
            )

    def __len__(self):
        return len(self.pictures)

    def lens(self):
        return [self.yaml.get(k, 0.0) for k in LENS]

    def grey(self, frame):
        path = self.folder / self.pictures[frame]
        image = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
        if image is None:
            sys.exit(f"{path}: no picture")
        if image.shape != (self.camera.height, self.camera.width):
            sys.exit(
                f"{path}: {image.shape[1]} x {image.shape[0]}, but camera.yaml says {self.camera.width} x {self.camera.height}"
            )
        return image

    def depth_path(self, frame):
        return self.folder / "depth" / f"{frame:04d}.png"

    def has_depth(self, frame):
        return self.depth_path(frame).is_file()

    def depth_m(self, frame):
        image = cv2.imread(str(self.depth_path(frame)), cv2.IMREAD_UNCHANGED)
        if image is None or image.dtype != np.uint16:
            sys.exit(f"{self.depth_path(frame)}: no 16-bit picture")
        return image * DEPTH_UNIT_M
