# SPDX-License-Identifier: BSD-3-Clause
"""The folder of one rendered sequence: where its pictures are and what stands beside them."""
import hashlib
import json
import sys

import animation

BLUR_SIGMA_PX = 0.6
TARGET_SIZE_M = [0.21, 0.1485]


def scene_lines(name):
    """The lines of a scene file and of what it includes; comments do not count."""
    for line in (animation.HERE / name).read_text().splitlines():
        if line.startswith('#include "'):
            yield from scene_lines(line.split('"')[1])
        elif line and not line.startswith("//"):
            yield line


def tables(sequence, args):
    """File name -> text; the first three must not change while a sequence is being rendered."""
    c, rows = sequence.camera, sequence.poses
    camera = [f"{k}: {getattr(c, k)}" for k in ("width", "height", "fx", "fy", "cx", "cy")] + [
        k + ": 0" for k in ("k1", "k2", "p1", "p2", "k3")
    ]
    truth = ["# timestamp tx ty tz qx qy qz qw   (T_world_camera, m; x right, y down, z forward)"]
    truth += [f"{r[0]:.6f} " + " ".join(f"{v:.9f}" for v in r[1:]) for r in rows]
    how = {
        "rays_per_side": sequence.rays_per_side,
        "blur_sigma_px": BLUR_SIGMA_PX,
        "noise_sigma_grey": args.noise,
        "jpeg_step": args.jpeg_step,
        "depth_every": sequence.depth_every,
        "scene": hashlib.sha256("\n".join(scene_lines(sequence.scene)).encode()).hexdigest()[:16],
    }
    marks = {"target": {"rectangle_size_m": TARGET_SIZE_M}, "segments": sequence.segments, "objects": sequence.objects}
    return {
        "camera.yaml": "\n".join(camera) + "\n",
        "groundtruth.txt": "\n".join(truth) + "\n",
        "render.json": json.dumps(how, indent=1) + "\n",
        "marks.json": json.dumps(marks, indent=1) + "\n",
        "rgb.txt": "\n".join(["# timestamp filename"] + [f"{r[0]:.6f} gray/{i:04d}.jpg" for i, r in enumerate(rows)])
        + "\n",
    }


def prepare(sequence, args):
    folder = args.output / sequence.name
    for sub in ("gray", "depth"):
        (folder / sub).mkdir(parents=True, exist_ok=True)
    for name, text in tables(sequence, args).items():
        path = folder / name
        if path.exists() and path.read_text() != text and name in ("camera.yaml", "groundtruth.txt", "render.json"):
            sys.exit(f"{path}: was rendered with other settings; name another OUTPUT or remove {folder}")
        path.write_text(text)
    return folder


def grey_file(folder, frame):
    return folder / "gray" / f"{frame:04d}.jpg"


def depth_file(folder, frame):
    return folder / "depth" / f"{frame:04d}.png"
