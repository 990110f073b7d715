# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures that desk.pov pastes on its objects: 8-bit grey PGM, sRGB, always the same."""
import os
import string

import cv2
import numpy as np

WORDS = ("frame map pixel sensor depth filter update search gate ray parallax inverse match joint gain state "
         "motion camera corner patch index loop angle metric scale hand desk paper wood light shadow").split()


def noise(rng, height, width, cell):
    """Value noise in [-1, 1] whose grains are about `cell` pixels wide."""
    grid = rng.uniform(-1, 1, (max(2, int(height / cell) + 2), max(2, int(width / cell) + 2))).astype(np.float32)
    return cv2.resize(grid, (width, height), interpolation=cv2.INTER_CUBIC)


def clutter(rng, height, width, count, largest):
    """Overlapping rectangles, discs, triangles and strokes of strong contrast."""
    img = np.full((height, width), float(rng.integers(60, 200)), np.float32)
    for _ in range(count):
        x, y = int(rng.integers(0, width)), int(rng.integers(0, height))
        s = int(largest * rng.uniform(0.15, 1.0) ** 2) + 3
        grey, kind = float(rng.choice([15, 45, 90, 150, 200, 240])), int(rng.integers(0, 4))
        if kind == 0:
            cv2.rectangle(img, (x, y), (x + s, y + int(s * rng.uniform(0.4, 1.6))), grey, -1)
        elif kind == 1:
            cv2.circle(img, (x, y), s // 2, grey, -1, cv2.LINE_AA)
        elif kind == 2:
            corners = np.array([x, y]) + rng.integers(-s, s + 1, (3, 2))
            cv2.fillPoly(img, [corners.astype(np.int32)], grey, cv2.LINE_AA)
        else:
            end = (x + int(rng.integers(-s, s + 1)), y + int(rng.integers(-s, s + 1)))
            cv2.line(img, (x, y), end, grey, int(rng.integers(1, 5)), cv2.LINE_AA)
    return img


def write_text(rng, img, box, size_px, grey):
    """Fills box (x0, y0, x1, y1) with lines of words, `size_px` high."""
    x0, y0, x1, y1 = box
    scale = size_px / 22.0
    y = y0 + size_px
    while y < y1:
        x = x0
        while True:
            word = str(rng.choice(WORDS))
            width = cv2.getTextSize(word, cv2.FONT_HERSHEY_SIMPLEX, scale, 1)[0][0]
            if x + width > x1:
                break
            cv2.putText(img, word, (x, y), cv2.FONT_HERSHEY_SIMPLEX, scale, grey, max(1, round(size_px / 9)), cv2.LINE_AA)
            x += width + int(0.6 * size_px)
        y += int(1.6 * size_px)
    return img


def page(rng):
    img = np.full((848, 600), 232.0, np.float32)
    write_text(rng, img, (40, 30, 560, 110), 40, 15)
    write_text(rng, img, (40, 130, 290, 480), 15, 25)
    img[140:400, 320:560] = clutter(rng, 260, 240, 60, 70)
    write_text(rng, img, (320, 410, 560, 640), 15, 25)
    img[500:700, 40:290] = clutter(rng, 200, 250, 40, 60)
    write_text(rng, img, (40, 720, 560, 820), 22, 25)
    return img


def cover(rng):
    img = clutter(rng, 560, 400, 110, 110)
    img = np.clip(img + 12 * noise(rng, 560, 400, 9), 0, 255)
    top = int(rng.integers(30, 300))
    dark = bool(rng.integers(0, 2))
    cv2.rectangle(img, (30, top), (370, top + 120), 25.0 if dark else 235.0, -1)
    return write_text(rng, img, (45, top + 10, 360, top + 110), 34, 235 if dark else 20)


def spine(rng):
    img = np.full((500, 90), float(rng.choice([30, 70, 120, 190, 225])), np.float32)
    ink = 240.0 if img[0, 0] < 100 else 20.0
    for y in (25, 60, 430, 470):
        cv2.rectangle(img, (0, y), (90, y + int(rng.integers(4, 16))), ink, -1)
    strip = write_text(rng, np.full((70, 330), img[0, 0], np.float32), (8, 6, 325, 66), 28, ink)
    img[85:415, 10:80] = cv2.rotate(strip, cv2.ROTATE_90_CLOCKWISE)
    return img + 10 * noise(rng, 500, 90, 5)


def wood(rng, height, width):
    y = np.arange(height, dtype=np.float32)[:, None]
    warp = 30 * noise(rng, height, width, 260) + 8 * noise(rng, height, width, 70)
    img = 135 + 10 * np.sin((y + warp) / 7) + 22 * np.sin((y + 2 * warp) / 23)
    img += 12 * cv2.resize(noise(rng, height, width // 30, 5), (width, height)) + 9 * noise(rng, height, width, 14)
    for _ in range(700):  # knots, stains, scratches
        x, y0 = int(rng.integers(0, width)), int(rng.integers(0, height))
        grey = float(rng.choice([25, 50, 215]))
        if rng.random() < 0.6:
            axes = (int(rng.integers(3, 12)), int(rng.integers(3, 8)))
            cv2.ellipse(img, (x, y0), axes, int(rng.integers(0, 180)), 0, 360, grey, -1, cv2.LINE_AA)
        else:
            end = (x + int(rng.integers(-60, 61)), y0 + int(rng.integers(-40, 41)))
            cv2.line(img, (x, y0), end, grey, int(rng.integers(1, 4)), cv2.LINE_AA)
    return img


def wall(rng, height, width):
    y, x = np.mgrid[0:height, 0:width].astype(np.float32)
    img = 150 + 30 * np.sign(np.sin(x / 9.5) * np.sin(y / 9.5)) + 30 * noise(rng, height, width, 18)
    return img + 10 * noise(rng, height, width, 6)


def carton(rng):
    img = 150 + 16 * noise(rng, 400, 480, 40) + 22 * noise(rng, 400, 480, 5)
    cv2.rectangle(img, (0, 180), (480, 215), 205.0, -1)
    cv2.rectangle(img, (30, 30), (230, 160), 235.0, -1)
    write_text(rng, img, (38, 36, 225, 155), 22, 20)
    for x in range(270, 450, 5):
        cv2.rectangle(img, (x, 40), (x + int(rng.integers(0, 4)), 140), 20.0, -1)
    return write_text(rng, img, (40, 240, 450, 390), 46, 30)


def label(rng):
    img = write_text(rng, np.full((200, 300), 228.0, np.float32), (12, 8, 290, 190), 34, 20)
    cv2.rectangle(img, (3, 3), (296, 196), 20.0, 4)
    return img


def ruler():
    img = np.full((56, 620), 225.0, np.float32)
    for mm in range(310):
        cv2.line(img, (2 * mm, 0), (2 * mm, 30 if mm % 10 == 0 else 20 if mm % 5 == 0 else 11), 25.0, 1)
        if mm % 10 == 0:
            cv2.putText(img, str(mm // 10), (2 * mm + 2, 50), cv2.FONT_HERSHEY_SIMPLEX, 0.5, 25.0, 1, cv2.LINE_AA)
    return img


def cube(rng):
    img = np.full((150, 150), 15.0, np.float32)
    for i in range(3):
        for j in range(3):
            cv2.rectangle(img, (50 * i + 4, 50 * j + 4), (50 * i + 45, 50 * j + 45), float(rng.choice([70, 120, 180, 240])), -1)
    return img


def single_sign(size, sign, paper):
    img = np.full((size, size), paper, np.float32)
    cv2.putText(img, sign, (int(0.25 * size), int(0.72 * size)), cv2.FONT_HERSHEY_SIMPLEX, size / 34, 245.0 - paper, max(1, size // 14), cv2.LINE_AA)
    return img


def pictures():
    """Name -> float image. Every picture has its own seed: changing one leaves the others alone."""
    def rng(name):
        return np.random.default_rng([ord(c) for c in name])
    out = {"wood": wood(rng("wood"), 1730, 2530), "wall": wall(rng("wall"), 1200, 2000), "ruler": ruler(),
           "carton": carton(rng("carton")), "label": label(rng("label")), "cube": cube(rng("cube")),
           "key": single_sign(48, string.ascii_uppercase[0], 205.0), "button": single_sign(40, "8", 225.0)}
    for i in range(6):
        out[f"cover{i}"], out[f"spine{i}"] = cover(rng(f"cover{i}")), spine(rng(f"spine{i}"))
    for i in range(2):
        out[f"page{i}"], out[f"mug{i}"] = page(rng(f"page{i}")), clutter(rng(f"mug{i}"), 200, 500, 90, 60)
    for i, shape in enumerate(((620, 460), (460, 620), (600, 440))):
        out[f"poster{i}"] = clutter(rng(f"poster{i}"), *shape, 130, 130) + 14 * noise(rng(f"grain{i}"), *shape, 5)
    out["parcel"] = write_text(rng("words"), clutter(rng("parcel"), 340, 500, 150, 80), (150, 120, 490, 190), 48, 250)
    out["grain"] = 110 + 50 * noise(rng("grain"), 200, 400, 6)
    out["leaves"] = 205 + 25 * cv2.resize(noise(rng("leaves"), 200, 30, 2.0), (400, 200))
    return out


def draw(folder):
    os.makedirs(folder, exist_ok=True)
    for name, img in pictures().items():
        cv2.imwrite(os.path.join(folder, name + ".pgm"), np.clip(img, 0, 255).astype(np.uint8))
