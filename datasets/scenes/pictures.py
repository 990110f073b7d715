# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of the rendered worlds: those of the desk at the scale that a camera can resolve, and some more."""

import cv2
import numpy as np

import textures

SHRINK = {"office.pov": 0.5, "lab.pov": 0.3, "corridor.pov": 0.3}


def blinds(rng):
    """A window with equal slats: each edge looks like the next one."""
    img = np.full((300, 260), 225.0, np.float32)
    for y in range(0, 300, 20):
        cv2.rectangle(img, (0, y), (260, y + 8), 60.0, -1)
    return img + 6 * textures.noise(rng, 300, 260, 10)


def coat(rng):
    img = 70 + 35 * textures.noise(rng, 500, 300, 40) + 20 * textures.noise(rng, 500, 300, 9)
    for y in range(30, 500, 60):
        cv2.circle(img, (150, y), 9, 225.0, -1, cv2.LINE_AA)
    cv2.rectangle(img, (30, 260), (110, 360), 30.0, 5)
    return textures.write_text(rng, img, (180, 90, 290, 140), 26, 235)


def screen(rng):
    img = np.full((500, 840), 235.0, np.float32)
    img[60:440, 420:800] = textures.clutter(rng, 380, 380, 120, 90)
    cv2.rectangle(img, (0, 0), (840, 34), 60.0, -1)
    return textures.write_text(rng, img, (24, 60, 400, 480), 24, 20)


def door(rng):
    img = 120 + 14 * textures.noise(rng, 800, 360, 30) + 12 * textures.noise(rng, 800, 360, 6)
    cv2.rectangle(img, (0, 0), (359, 799), 40.0, 14)
    cv2.rectangle(img, (70, 90), (290, 330), 215.0, -1)
    cv2.circle(img, (320, 430), 13, 235.0, -1, cv2.LINE_AA)
    return textures.write_text(rng, img, (84, 100, 280, 320), 40, 25)


def drawn():
    """Name -> 8-bit picture."""
    out = textures.pictures()
    for name, make in (("blinds", blinds), ("coat", coat), ("screen", screen), ("door", door)):
        out[name] = make(np.random.default_rng([ord(c) for c in name]))
    return {name: np.clip(img, 0, 255).astype(np.uint8) for name, img in out.items()}


def draw(folder, scene):
    folder.mkdir(parents=True, exist_ok=True)
    for name, img in drawn().items():
        size = [max(16, round(SHRINK[scene] * n)) for n in img.shape[::-1]]
        cv2.imwrite(str(folder / (name + ".pgm")), cv2.resize(img, size, interpolation=cv2.INTER_AREA))
