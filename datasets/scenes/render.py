#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Renders the sequences `desk` and `desk_moving` in the TUM layout. Frames already there are kept."""
import argparse
import os
import subprocess
import sys
import tempfile

import cv2
import numpy as np
from PIL import Image

import textures
import trajectory as tj

HERE = os.path.dirname(os.path.abspath(__file__))
WIDTH, HEIGHT = 640, 480
FX, FY, CX, CY = 481.2, 480.0, 319.5, 239.5
DEPTH_UNIT_M = 1 / 5000.0  # of a depth PNG, as TUM has it
RAYS_PER_SIDE = {"desk": 3, "desk_moving": 2}  # of a pixel; their mean is the anti-aliasing
BLUR_SIGMA_PX, NOISE_SIGMA_GREY = 0.6, 2.0
JPEG_STEP = 16  # one quantiser step for all frequencies: at equal size 10 % less error than the usual tables


def povray(pose, box_x_m, depth, pictures, out, scale):
    """One render: 16-bit linear grey, no adaptive anti-aliasing (we average `scale` x `scale` rays)."""
    R = tj.rotation(pose[4:])
    value = {"Tx": pose[1], "Ty": pose[2], "Tz": pose[3], "BoxX": box_x_m, "Depth": int(depth), "Far": 65535 * DEPTH_UNIT_M}
    value.update({a + b: R[j, i] for i, a in enumerate("XYZ") for j, b in enumerate("xyz")})
    command = ["povray", "+I" + os.path.join(HERE, "desk.pov"), "+L" + HERE, "+L" + pictures, "+O" + out,
               f"+W{WIDTH * scale}", f"+H{HEIGHT * scale}", "+FP16", "Grayscale_Output=on", "File_Gamma=1.0",
               "-A", "-D", "+WT1"] + [f"Declare={k}={v:.16g}" for k, v in value.items()]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit("povray failed:\n" + done.stderr[-3000:])
    image = cv2.imread(out + ".ppm", cv2.IMREAD_UNCHANGED)
    os.remove(out + ".ppm")
    return image if image.ndim == 2 else image[:, :, 0]


def srgb(linear):
    return 255 * np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * np.maximum(linear, 1e-9) ** (1 / 2.4) - 0.055)


def clean_grey(name, frame, pictures, work):
    """The frame after the lens (blur, mean over the pixel) and before the sensor's noise; float sRGB levels."""
    s = RAYS_PER_SIDE[name]
    pose, x = tj.poses(name)[frame], tj.box_x(name, frame)
    fine = povray(pose, x, False, pictures, os.path.join(work, "grey"), s).astype(np.float32) / 65535
    fine = cv2.GaussianBlur(fine, (0, 0), BLUR_SIGMA_PX * s)
    return srgb(fine.reshape(HEIGHT, s, WIDTH, s).mean(axis=(1, 3)))


def depth_image(name, frame, pictures, work):
    """z-depth at the pixel centres, in DEPTH_UNIT_M."""
    return povray(tj.poses(name)[frame], tj.box_x(name, frame), True, pictures, os.path.join(work, "depth"), 1)


def project(pose, points_w):
    p = (points_w - pose[1:4]) @ tj.rotation(pose[4:])
    return np.column_stack([FX * p[:, 0] / p[:, 2] + CX, FY * p[:, 1] / p[:, 2] + CY])


def write_lines(path, lines):
    with open(path, "w", newline="\n") as f:
        f.write("\n".join(lines) + "\n")


def write_tables(name, folder):
    """groundtruth.txt, rgb.txt, camera.yaml and, for the moving box, its motion and outline."""
    rows = tj.poses(name)
    text = [f"{r[0]:.6f} " + " ".join(f"{v:.9f}" for v in r[1:]) for r in rows]
    write_lines(os.path.join(folder, "groundtruth.txt"),
                ["# timestamp tx ty tz qx qy qz qw   (T_world_camera, z forward, x right, y down)"] + text)
    write_lines(os.path.join(folder, "rgb.txt"),
                ["# timestamp filename"] + [f"{r[0]:.6f} gray/{i:04d}.jpg" for i, r in enumerate(rows)])
    write_lines(os.path.join(folder, "camera.yaml"),
                [f"width: {WIDTH}", f"height: {HEIGHT}", f"fx: {FX}", f"fy: {FY}", f"cx: {CX}", f"cy: {CY}"]
                + [k + ": 0" for k in ("k1", "k2", "p1", "p2", "k3")])
    if name != "desk_moving":
        return
    x = [tj.box_x(name, i) for i in range(len(rows))]
    write_lines(os.path.join(folder, "object_motion.txt"),
                ["# timestamp tx ty tz qx qy qz qw   (T_world_box; origin: middle of the base; size 0.34 0.14 0.28 m)"]
                + [f"{r[0]:.6f} {x[i]:.9f} {tj.BOX_Y_M:.9f} 0 0 0 0 1" for i, r in enumerate(rows)])
    hulls = [cv2.convexHull(project(r, tj.box_corners(x[i])).astype(np.float32))[:, 0] for i, r in enumerate(rows)]
    write_lines(os.path.join(folder, "object_polygon.txt"),
                ["# timestamp u0 v0 u1 v1 ...   (px; convex outline of the box, not clipped to the image)"]
                + [f"{r[0]:.6f} " + " ".join(f"{v:.3f}" for v in h.ravel()) for r, h in zip(rows, hulls)])


def save(path, image, **options):
    """Written aside and renamed, so that an interrupted frame is never taken for a finished one."""
    base, ext = os.path.splitext(path)
    Image.fromarray(image).save(base + ".part" + ext, **options)
    os.replace(base + ".part" + ext, path)


def render(name, args, pictures, work):
    folder = os.path.join(args.output, name)
    for sub in ("gray", "depth"):
        os.makedirs(os.path.join(folder, sub), exist_ok=True)
    write_tables(name, folder)
    frames = tj.FRAMES[name]
    for i in range(frames):
        grey, depth = (os.path.join(folder, sub, f"{i:04d}.{ext}") for sub, ext in (("gray", "jpg"), ("depth", "png")))
        if "gray" in args.what and not os.path.exists(grey):
            rng = np.random.default_rng([sum(map(ord, name)), i])
            noisy = clean_grey(name, i, pictures, work) + rng.normal(0, NOISE_SIGMA_GREY, (HEIGHT, WIDTH))
            save(grey, np.clip(np.rint(noisy), 0, 255).astype(np.uint8), qtables=[[args.jpeg_step] * 64],
                 optimize=True, progressive=True)
        if "depth" in args.what and i % args.depth_every == 0 and not os.path.exists(depth):
            save(depth, depth_image(name, i, pictures, work), optimize=True)
        print(f"\r{name}: {i + 1}/{frames}", end="", flush=True)
    print()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", help="folder that receives desk/ and desk_moving/")
    parser.add_argument("--sequence", choices=sorted(tj.FRAMES), action="append", help="only this one (repeatable)")
    parser.add_argument("--what", choices=("gray", "depth"), nargs="+", default=["gray", "depth"])
    parser.add_argument("--depth-every", type=int, default=1, metavar="N", help="depth of every Nth frame only")
    parser.add_argument("--jpeg-step", type=int, default=JPEG_STEP, help="JPEG quantiser step (default %(default)s)")
    args = parser.parse_args()
    os.makedirs(args.output, exist_ok=True)
    with tempfile.TemporaryDirectory() as work:
        textures.draw(os.path.join(work, "pictures"))
        for name in args.sequence or sorted(tj.FRAMES):
            render(name, args, os.path.join(work, "pictures"), work)


if __name__ == "__main__":
    main()
