#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Accuracy, robustness of the start and time on real sequences, as a Markdown table.

    apps/experiments/real-sequences/run.py [--datasets DIR] [--output DIR] [--only NAME ...] [--jobs N]

Runs config/default.ini on every sequence with five seeds, and with seed 1 from frames 1 to 10, 20,
30, 40 and at half rate. Only the camera and the target of chessboard_desk are named: a first run
with camera.estimate_readout says how slowly the shutter rolls, which is what camera.readout_s is in
all others; nothing else changes.
Finished runs are kept, so that an interrupted call goes on where it was.
"""
import argparse
import concurrent.futures
import json
import os
import statistics
import subprocess
import sys

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), *[os.pardir] * 3))
BOARD = ["metric_start.method=chessboard", "metric_start.chessboard_inner_corners=9 6",
         "metric_start.chessboard_square_m=0.04"]
# name: (alignment, must [mm], must [deg], settings)
SEQUENCES = {
    "chessboard_desk": ("SE3", 5.0, 0.5, BOARD),
    "living_room": ("Sim3", 6.0, 0.4, []),
    "red_kitchen": ("Sim3", 45.0, 3.2, []),
    "phone_desk": (None, 1.0, None, []),
    "fr1_rpy": ("Sim3", None, 15.0, []),
}
SEEDS = [(0, 1, seed) for seed in range(1, 6)]
STARTS = [(first, 1, 1) for first in [*range(1, 11), 20, 30, 40]] + [(0, 2, 1)]


def program(name):
    return os.path.join(ROOT, "build", "release", "bin", name)


def call(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(command)}\n{done.stderr}")


def make_rawlog(name, args):
    rawlog = os.path.join(args.output, name + ".rawlog")
    folder = os.path.join(args.datasets, name)
    truth = os.path.join(folder, "groundtruth.txt")
    if not os.path.exists(rawlog):
        call(program("images2rawlog"), "--format", "tum", "--input", folder, "--camera",
             os.path.join(folder, "camera.yaml"), "--output", rawlog, "--force",
             *(["--groundtruth", truth] if os.path.exists(truth) else []))
    return rawlog


def readout_s(name, args):
    """Of the camera's shutter, to a millisecond, by a run of its own over the whole sequence."""
    output = os.path.join(args.output, f"{name}_readout")
    summary = os.path.join(output, "summary.json")
    if not os.path.exists(summary):
        settings = [*SEQUENCES[name][3], "camera.estimate_readout=true"]
        call(program("mono-slam"), os.path.join(ROOT, "config", "default.ini"),
             os.path.join(args.output, name + ".rawlog"), "--output", output, "--force",
             *[word for s in settings for word in ("--set", s)])
    with open(summary) as stream:
        return round(json.load(stream)["readout_s"], 3)


def run(name, variant, readout, args):
    first, every, seed = variant
    output = os.path.join(args.output, f"{name}_{first}_{every}_{seed}")
    figures = os.path.join(output, "figures.json")
    truth = os.path.join(args.datasets, name, "groundtruth.txt")
    if not os.path.exists(figures):
        settings = [*SEQUENCES[name][3], f"rawlog.first_frame={first}", f"rawlog.every_nth={every}",
                    f"camera.readout_s={readout}"]
        call(program("mono-slam"), os.path.join(ROOT, "config", "default.ini"),
             os.path.join(args.output, name + ".rawlog"), "--output", output, "--force", "--seed",
             str(seed), *[word for s in settings for word in ("--set", s)])
        mode = ["--groundtruth", truth] if os.path.exists(truth) else ["--out-and-back"]
        call(program("mono-slam-eval"), *mode, output, "--json", figures)
    with open(figures) as stream:
        return json.load(stream)[0]


def spread(values, digits=1):
    values = [v for v in values if v is not None]
    if not values:
        return "-"
    return f"{statistics.median(values):.{digits}f} / {max(values, key=abs):.{digits}f}"


def error(name, figures):
    """The sequence's own figure: mm after its alignment, or the gap in percent of the length."""
    alignment = SEQUENCES[name][0]
    return figures[f"{alignment}_ate_rmse_mm"] if alignment else figures["gap_pct"]


def rotation(name, figures):
    alignment = SEQUENCES[name][0]
    return figures.get("rotation_own_rms_deg") if alignment else None


def meets_twice(name, figures):
    _, must, degrees, _ = SEQUENCES[name]
    good = must is None or error(name, figures) <= 2 * must
    return good and (degrees is None or rotation(name, figures) <= 2 * degrees)


def warned(figures):
    return figures["frames_lost"] + figures["frames_degraded"] > 0


def row(name, readout, seeds, starts):
    own = [error(name, f) for f in seeds]
    bad = [f for f in starts if not meets_twice(name, f)]
    drift = [f.get("scale_drift_pct") for f in seeds]
    cells = [name, f"{1000 * readout:.0f}", "%" if SEQUENCES[name][0] is None else SEQUENCES[name][0] + " mm", spread(own, 2),
             spread([rotation(name, f) for f in seeds], 2),
             spread([f.get("scale_error_pct") if SEQUENCES[name][0] == "SE3" else None for f in seeds], 2),
             spread(drift), spread([error(name, f) for f in starts], 2),
             f"{len(starts) - len(bad)} of {len(starts)}",
             f"{sum(warned(f) for f in bad)} of {len(bad)}",
             str(max(f["frames_lost"] for f in seeds)),
             f"{statistics.median(f['time_median_ms'] for f in seeds):.1f}",
             f"{statistics.median(f['time_p995_ms'] for f in seeds):.1f}",
             f"{max(f['time_max_ms'] for f in seeds):.1f}"]
    return "| " + " | ".join(cells) + " |"


HEADER = """| sequence | readout [ms] | figure | 5 seeds: median / worst | rotation [deg] | scale error [%] | scale drift, thirds [%] | other starts and half rate: median / worst | of them within twice the must | of the others: warned | frames lost | median [ms] | 99.5 % [ms] | worst [ms] |
|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--datasets", default=os.environ.get(
        "MONOSLAM_DATASETS", os.path.join(ROOT, os.pardir, "shared", "datasets")))
    parser.add_argument("--output", default=os.path.join(ROOT, "build", "real-sequences"))
    parser.add_argument("--only", nargs="+", choices=SEQUENCES, default=list(SEQUENCES))
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    if not os.path.isdir(args.datasets):
        sys.exit(f"{args.datasets}: no such folder; name it by --datasets or MONOSLAM_DATASETS")
    os.makedirs(args.output, exist_ok=True)
    print(HEADER)
    for name in args.only:
        make_rawlog(name, args)
        readout = readout_s(name, args)
        with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
            runs = list(pool.map(lambda v: run(name, v, readout, args), SEEDS + STARTS))
        print(row(name, readout, runs[:len(SEEDS)], runs[len(SEEDS):]), flush=True)


if __name__ == "__main__":
    main()
