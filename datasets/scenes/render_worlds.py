#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Renders a world of sequences in the TUM layout, by one POV-Ray process a job. Frames already there are kept."""

import argparse
import os
import shutil
import signal
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

import cv2
import numpy as np

import animation
import lab
import office
import pictures
from render import save, srgb
from world_folder import BLUR_SIGMA_PX, depth_file, grey_file, prepare

FRAMES_A_PROCESS = 100
WORLDS = {
    "office": lambda: office.sequences(False),
    "lab": lambda: lab.sequences(False),
    "quick": lambda: lab.sequences(True) + office.sequences(True),
}


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
                print(
                    f"{self.done}/{self.total} pictures ({name}), {(now - self.start) / self.done:.2f} s each, "
                    f"{left / 60:.1f} min left",
                    flush=True,
                )


def chunks(sequence, folder, what):
    """(depth, frames) of one process each, of the frames that are missing."""
    wanted = {
        "gray": [i for i in range(len(sequence.poses)) if not grey_file(folder, i).exists()],
        "depth": [i for i in range(0, len(sequence.poses), sequence.depth_every) if not depth_file(folder, i).exists()],
    }
    return [
        (kind == "depth", wanted[kind][i : i + FRAMES_A_PROCESS])
        for kind in what
        for i in range(0, len(wanted[kind]), FRAMES_A_PROCESS)
    ]


def sensed(linear, sequence, frame, noise_sigma_grey):
    """The frame after the lens (blur, mean over the pixel) and a still sensor's noise, 8-bit sRGB."""
    size = sequence.camera.width, sequence.camera.height
    fine = cv2.GaussianBlur(linear.astype(np.float32) / 65535, (0, 0), BLUR_SIGMA_PX * sequence.rays_per_side)
    rng = np.random.default_rng([sum(map(ord, sequence.name)), frame])
    noisy = srgb(cv2.resize(fine, size, interpolation=cv2.INTER_AREA)) + rng.normal(0, noise_sigma_grey, size[::-1])
    return np.clip(np.rint(noisy), 0, 255).astype(np.uint8)


def render_chunk(task, args, work, progress):
    sequence, folder, depth, frames = task
    with tempfile.TemporaryDirectory(dir=work) as own:
        for frame, image in animation.animate(sequence, frames, depth, work / sequence.scene, Path(own)):
            if depth:
                save(str(depth_file(folder, frame)), image)
            else:
                save(
                    str(grey_file(folder, frame)),
                    sensed(image, sequence, frame, args.noise),
                    qtables=[[args.jpeg_step] * 64],
                )
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
    parser.add_argument(
        "--jobs",
        type=int,
        default=2 * os.cpu_count(),
        help="POV-Ray processes; each sleeps 0.25 s between two frames, so two a core (default %(default)s)",
    )
    parser.add_argument("--noise", type=float, default=2.0, help="sensor noise [grey levels rms] (default %(default)s)")
    parser.add_argument("--jpeg-step", type=int, default=8, help="JPEG quantiser step (default %(default)s)")
    args = parser.parse_args()
    if args.jobs < 1 or args.noise < 0 or not 1 <= args.jpeg_step <= 255:
        parser.error("--jobs must be >= 1, --noise >= 0, --jpeg-step 1 to 255")
    return args


def main():
    args = arguments()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
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
        for done in as_completed([pool.submit(render_chunk, t, args, work, progress) for t in tasks]):
            done.result()
    except animation.PovrayFailed as failure:
        sys.exit(f"povray failed: {failure}")
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for povray in list(animation.RUNNING):
            povray.terminate()
        pool.shutdown()
        shutil.rmtree(work, ignore_errors=True)
    print(f"{progress.done} pictures rendered, {(time.monotonic() - progress.start) / 60:.1f} min")


if __name__ == "__main__":
    main()
