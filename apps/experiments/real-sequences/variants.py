#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The real sequences as other cameras would have recorded them, as a Markdown table.

    build/venv-report/bin/python apps/experiments/real-sequences/variants.py [--datasets DIR] [--output DIR] [--only NAME ...]
                                                                             [--jobs N]

Every sequence is changed in eight ways, its truth and calibration with it, and run with config/default.ini from its first frame
with two seeds, at half rate with two seeds, at a third of the rate, and from frames 20 and 40 (not phone_desk, which would not
come back to where it began). Camera, target and readout are named as in run.py. Finished runs are kept. The Python packages are those
of the report (apps/mono-slam-report/install.sh).
"""
import argparse
import concurrent.futures
import os
import statistics
import sys
import types

import numpy
from PIL import Image

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "common"))
from run import meets_twice, rotation, warned  # noqa: E402
from sequences import (ROOT, SEQUENCES, add_arguments, error, make_rawlog,  # noqa: E402
                       readout_s, run_once, settings_as_arguments)

RUNS = [(0, 1, 1), (0, 1, 2), (0, 2, 1), (0, 2, 2), (0, 3, 1), (20, 1, 1), (40, 1, 1)]
SEED = 7  # of noise and gains
QUALITY = 95


def lines_of(path):
    with open(path) as stream:
        return [line.split() for line in stream if line.strip() and not line.startswith("#")]


def read_camera(path):
    with open(path) as stream:
        return {key.strip(): float(value) for key, value in (line.split(":") for line in stream if ":" in line)}


class Sequence:
    """Frames (time, file), truth (rows of a TUM file, or nothing) and calibration."""

    def __init__(self, folder):
        self.folder = folder
        self.frames = [(float(t), name) for t, name in lines_of(os.path.join(folder, "rgb.txt"))]
        truth = os.path.join(folder, "groundtruth.txt")
        self.truth = numpy.array(lines_of(truth), float) if os.path.exists(truth) else None
        self.camera = read_camera(os.path.join(folder, "camera.yaml"))
        self.rng = numpy.random.default_rng(SEED)

    def mirror_truth(self, axis):
        """S R S and S t with S = diag(..., -1 at the axis, ...)."""
        if self.truth is None:
            return
        self.truth[:, 1 + axis] *= -1.0
        for other in {0, 1, 2} - {axis}:
            self.truth[:, 4 + other] *= -1.0


def mirrored(sequence):
    """Left and right exchanged."""
    sequence.mirror_truth(0)
    sequence.camera["cx"] = sequence.camera["width"] - 1 - sequence.camera["cx"]
    sequence.camera["p2"] *= -1.0
    return lambda image, _index: image[:, ::-1]


def backwards(sequence):
    """Last frame first, and upside down: a shutter that rolled downwards still does."""
    sequence.mirror_truth(1)
    sequence.camera["cy"] = sequence.camera["height"] - 1 - sequence.camera["cy"]
    sequence.camera["p1"] *= -1.0
    turn = sequence.frames[0][0] + sequence.frames[-1][0]
    sequence.frames = [(turn - t, name) for t, name in reversed(sequence.frames)]
    if sequence.truth is not None:
        sequence.truth = sequence.truth[::-1]
        sequence.truth[:, 0] = turn - sequence.truth[:, 0]
    return lambda image, _index: image[::-1]


def half_size(sequence):
    camera = sequence.camera
    for key in ("fx", "fy", "width", "height"):
        camera[key] *= 0.5
    for key in ("cx", "cy"):
        camera[key] = 0.5 * (camera[key] + 0.5) - 0.5
    size = int(camera["width"]), int(camera["height"])
    return lambda image, _index: numpy.asarray(Image.fromarray(image).resize(size, Image.Resampling.BOX))


def cropped(sequence):
    """The middle three quarters: a narrower lens."""
    camera = sequence.camera
    w, h = int(camera["width"]) * 3 // 4, int(camera["height"]) * 3 // 4
    x, y = (int(camera["width"]) - w) // 2, (int(camera["height"]) - h) // 2
    camera.update(width=w, height=h, cx=camera["cx"] - x, cy=camera["cy"] - y)
    return lambda image, _index: image[y:y + h, x:x + w]


def noisy(image, gain, offset, sigma, rng):
    return numpy.clip(image * gain + offset + rng.normal(0.0, sigma, image.shape), 0, 255).astype(numpy.uint8)


def dim(sequence):
    """A third of the light, noise of 2.5 grey levels."""
    return lambda image, _index: noisy(image, 0.35, 10.0, 2.5, sequence.rng)


def flickering(sequence):
    """A gain that wanders by 4 % a frame within a factor of three, noise of 2 grey levels."""
    logs = numpy.cumsum(sequence.rng.normal(0.0, 0.04, len(sequence.frames)))
    gains = numpy.clip(numpy.exp(logs - 0.5 * (logs.max() + logs.min())), 0.5, 1.5)
    return lambda image, index: noisy(image, gains[index], 0.0, 2.0, sequence.rng)


def covered(sequence):
    """Twenty frames in the middle show a lens in the dark."""
    dark = range(len(sequence.frames) // 2, len(sequence.frames) // 2 + 20)
    return lambda image, index: noisy(image, 0.02, 30.0, 2.0, sequence.rng) if index in dark else image


def interrupted(sequence):
    """Forty frames are missing in the middle."""
    middle = len(sequence.frames) // 2
    del sequence.frames[middle:middle + 40]
    return lambda image, _index: image


VARIANTS = {"mirrored": mirrored, "backwards": backwards, "half size": half_size, "cropped": cropped, "dim": dim,
            "flickering": flickering, "covered": covered, "interrupted": interrupted}


def write_variant(source, folder, change):
    """A folder in TUM's layout; rgb.txt, written last, says that it is complete."""
    if os.path.exists(os.path.join(folder, "rgb.txt")):
        return
    sequence = Sequence(source)
    of_image = change(sequence)
    os.makedirs(os.path.join(folder, "gray"), exist_ok=True)
    index = []
    for k, (t_s, name) in enumerate(sequence.frames):
        image = of_image(numpy.asarray(Image.open(os.path.join(source, name)).convert("L")), k)
        Image.fromarray(numpy.ascontiguousarray(image)).save(os.path.join(folder, f"gray/{k:04d}.jpg"), quality=QUALITY)
        index.append(f"{t_s:.6f} gray/{k:04d}.jpg\n")
    if sequence.truth is not None:
        numpy.savetxt(os.path.join(folder, "groundtruth.txt"), sequence.truth, fmt="%.9f")
    with open(os.path.join(folder, "camera.yaml"), "w") as stream:
        for key, value in sequence.camera.items():
            stream.write(f"{key}: {int(value) if key in ('width', 'height') else repr(float(value))}\n")
    with open(os.path.join(folder, "rgb.txt"), "w") as stream:
        stream.writelines(index)


def run(name, variant, readout, first, every, seed, args):
    folder = f"{name} {variant}".replace(" ", "_")
    settings = [*SEQUENCES[name][3], f"rawlog.first_frame={first}", f"rawlog.every_nth={every}", f"camera.readout_s={readout}"]
    return run_once(os.path.join(args.output, f"{folder}_{first}_{every}_{seed}"),
                    os.path.join(ROOT, "config", "default.ini"), os.path.join(args.output, folder + ".rawlog"),
                    os.path.join(args.output, "sequences", folder, "groundtruth.txt"),
                    ["--seed", str(seed), *settings_as_arguments(settings)])


def row(name, variant, runs):
    errors = [error(name, f) for f in runs]
    turns = [t for t in (rotation(name, f) for f in runs) if t is not None]
    bad = [f for f in runs if not meets_twice(name, f)]
    unit = "%" if SEQUENCES[name][0] is None else SEQUENCES[name][0] + " mm"
    return (f"| {name} | {variant} | {unit} | {statistics.median(errors):.2f} / {max(errors):.2f} | "
            + (f"{statistics.median(turns):.2f} / {max(turns):.2f}" if turns else "-")
            + f" | {len(runs) - len(bad)} of {len(runs)} | {sum(warned(f) for f in bad)} of {len(bad)} | "
            f"{max(f['frames_lost'] for f in runs)} | {statistics.median(f['time_median_ms'] for f in runs):.1f} |")


HEADER = """| sequence | variant | figure | median / worst | rotation [deg] | within twice the must | of the others: warned | frames lost | median frame [ms] |
|---|---|---|---|---|---|---|---|---|"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    add_arguments(parser, "variants")
    parser.add_argument("--only", nargs="+", choices=SEQUENCES, default=list(SEQUENCES))
    args = parser.parse_args()
    if not os.path.isdir(args.datasets):
        sys.exit(f"{args.datasets}: no such folder; name it by --datasets or MONOSLAM_DATASETS")
    changed = os.path.join(args.output, "sequences")
    os.makedirs(changed, exist_ok=True)
    print(HEADER)
    for name in args.only:
        make_rawlog(name, args)
        readout = readout_s(name, args)
        jobs = [job for job in RUNS if SEQUENCES[name][0] or job[0] == 0]
        for variant, change in VARIANTS.items():
            folder = f"{name} {variant}".replace(" ", "_")
            write_variant(os.path.join(args.datasets, name), os.path.join(changed, folder), change)
            make_rawlog(folder, types.SimpleNamespace(output=args.output, datasets=changed))
            with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
                runs = list(pool.map(lambda job: run(name, variant, readout, *job, args), jobs))
            print(row(name, variant, runs), flush=True)


if __name__ == "__main__":
    main()
