#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Renders a world of sequences in the TUM layout, by one POV-Ray process a job. Frames already there are kept."""
import argparse
import hashlib
import json
import os
import shutil
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import cv2
import numpy as np

import animation
import lab
import office
import pictures
from render import save, srgb

RAYS_PER_SIDE = {"office.pov": 2, "lab.pov": 1.5, "corridor.pov": 1.5}  # of a pixel; their mean is the anti-aliasing
BLUR_SIGMA_PX = 0.6
FRAMES_A_PROCESS = 100
TARGET_SIZE_M = [0.21, 0.1485]
WORLDS = {"office": lambda: office.sequences(False), "lab": lambda: lab.sequences(False),
          "quick": lambda: lab.sequences(True) + office.sequences(True)}


class Progress:
    """One line a few seconds, with the time that is left at the present speed."""

    def __init__(self, total):
        self.total, self.done, self.start, self.said, self.lock = total, 0, time.monotonic(), 0.0, threading.Lock()

    def count(self, name):
        with self.lock:
            self.done += 1
            now = time.monotonic()
            if now - self.said > 5 or self.done == self.total:
                self.said = now
                left = (now - self.start) / self.done * (self.total - self.done)
                print(f"{self.done}/{self.total} pictures ({name}), {(now - self.start) / self.done:.2f} s each, "
                      f"{left / 60:.1f} min left", flush=True)


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
    camera = [f"{k}: {getattr(c, k)}" for k in ("width", "height", "fx", "fy", "cx", "cy")] + [k + ": 0" for k in ("k1", "k2", "p1", "p2", "k3")]
    truth = ["# timestamp tx ty tz qx qy qz qw   (T_world_camera, m; x right, y down, z forward)"]
    truth += [f"{r[0]:.6f} " + " ".join(f"{v:.9f}" for v in r[1:]) for r in rows]
    how = {"rays_per_side": RAYS_PER_SIDE[sequence.scene], "blur_sigma_px": BLUR_SIGMA_PX, "noise_sigma_grey": args.noise,
           "jpeg_step": args.jpeg_step, "depth_every": sequence.depth_every, "scene": hashlib.sha256("\n".join(scene_lines(sequence.scene)).encode()).hexdigest()[:16]}
    marks = {"target": {"rectangle_size_m": TARGET_SIZE_M}, "segments": sequence.segments, "objects": sequence.objects}
    return {"camera.yaml": "\n".join(camera) + "\n", "groundtruth.txt": "\n".join(truth) + "\n",
            "render.json": json.dumps(how, indent=1) + "\n", "marks.json": json.dumps(marks, indent=1) + "\n",
            "rgb.txt": "\n".join(["# timestamp filename"] + [f"{r[0]:.6f} gray/{i:04d}.jpg" for i, r in enumerate(rows)]) + "\n"}


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


def chunks(sequence, folder, what):
    """(depth, frames) of one process each, of the frames that are missing."""
    wanted = {"gray": [i for i in range(len(sequence.poses)) if not grey_file(folder, i).exists()],
              "depth": [i for i in range(0, len(sequence.poses), sequence.depth_every) if not depth_file(folder, i).exists()]}
    return [(kind == "depth", wanted[kind][i:i + FRAMES_A_PROCESS]) for kind in what for i in range(0, len(wanted[kind]), FRAMES_A_PROCESS)]


def sensed(linear, sequence, frame, noise_sigma_grey):
    """The frame after the lens (blur, mean over the pixel) and a still sensor's noise, 8-bit sRGB."""
    size = sequence.camera.width, sequence.camera.height
    fine = cv2.GaussianBlur(linear.astype(np.float32) / 65535, (0, 0), BLUR_SIGMA_PX * RAYS_PER_SIDE[sequence.scene])
    rng = np.random.default_rng([sum(map(ord, sequence.name)), frame])
    noisy = srgb(cv2.resize(fine, size, interpolation=cv2.INTER_AREA)) + rng.normal(0, noise_sigma_grey, size[::-1])
    return np.clip(np.rint(noisy), 0, 255).astype(np.uint8)


def render_chunk(task, args, work, progress):
    sequence, folder, depth, frames = task
    with tempfile.TemporaryDirectory(dir=work) as own:
        for frame, image in animation.animate(sequence, frames, depth, RAYS_PER_SIDE[sequence.scene], work / sequence.scene, Path(own)):
            if depth:
                save(str(depth_file(folder, frame)), image)
            else:
                save(str(grey_file(folder, frame)), sensed(image, sequence, frame, args.noise), qtables=[[args.jpeg_step] * 64])
            progress.count(sequence.name)


def chosen(args):
    every = {s.name: s for world in args.world for s in WORLDS[world]()}
    unknown = [n for n in args.sequence or [] if n not in every]
    if unknown:
        sys.exit(f"--sequence {unknown[0]}: {' and '.join(args.world)} has {', '.join(every)}")
    return [every[n] for n in args.sequence or every]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, prog="render.sh")
    parser.add_argument("output", type=Path, help="folder that receives a folder a sequence")
    parser.add_argument("--world", choices=sorted(WORLDS), action="append", required=True)
    parser.add_argument("--sequence", action="append", help="only this one (repeatable)")
    parser.add_argument("--what", choices=("gray", "depth"), nargs="+", default=["gray", "depth"])
    parser.add_argument("--jobs", type=int, default=2 * os.cpu_count(),
                        help="POV-Ray processes; each sleeps 0.25 s between two frames, so two a core (default %(default)s)")
    parser.add_argument("--noise", type=float, default=2.0, help="sensor noise [grey levels rms] (default %(default)s)")
    parser.add_argument("--jpeg-step", type=int, default=8, help="JPEG quantiser step (default %(default)s)")
    args = parser.parse_args()
    if args.jobs < 1 or args.noise < 0 or not 1 <= args.jpeg_step <= 255:
        parser.error("--jobs must be >= 1, --noise >= 0, --jpeg-step 1 to 255")
    return args


def main():
    args = arguments()
    cv2.setNumThreads(1)
    tasks = []
    for sequence in chosen(args):
        folder = prepare(sequence, args)
        tasks += [(sequence, folder, depth, frames) for depth, frames in chunks(sequence, folder, args.what)]
    progress = Progress(sum(len(t[3]) for t in tasks))
    work = Path(tempfile.mkdtemp())
    pool = ThreadPoolExecutor(args.jobs)
    try:
        for scene in {t[0].scene for t in tasks}:
            pictures.draw(work / scene, scene)
        for done in [pool.submit(render_chunk, t, args, work, progress) for t in tasks]:
            done.result()
    except animation.PovrayFailed as failure:
        sys.exit(f"povray failed: {failure}")
    finally:
        pool.shutdown(cancel_futures=True)
        shutil.rmtree(work, ignore_errors=True)
    print(f"{progress.done} pictures rendered, {(time.monotonic() - progress.start) / 60:.1f} min")


if __name__ == "__main__":
    main()
