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
import os
import statistics
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "common"))
from sequences import (ROOT, SEQUENCES, add_arguments, error, make_rawlog,  # noqa: E402
                       readout_s, run_once, settings_as_arguments)

SEEDS = [(0, 1, seed) for seed in range(1, 6)]
STARTS = [(first, 1, 1) for first in [*range(1, 11), 20, 30, 40]] + [(0, 2, 1)]


def run(name, variant, readout, args):
    first, every, seed = variant
    settings = [*SEQUENCES[name][3], f"rawlog.first_frame={first}", f"rawlog.every_nth={every}",
                f"camera.readout_s={readout}"]
    return run_once(os.path.join(args.output, f"{name}_{first}_{every}_{seed}"),
                    os.path.join(ROOT, "config", "default.ini"),
                    os.path.join(args.output, name + ".rawlog"),
                    os.path.join(args.datasets, name, "groundtruth.txt"),
                    ["--seed", str(seed), *settings_as_arguments(settings)])


def spread(values, digits=1):
    values = [v for v in values if v is not None]
    if not values:
        return "-"
    return f"{statistics.median(values):.{digits}f} / {max(values, key=abs):.{digits}f}"


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
             spread([rotation(name, f) for f in starts], 2),
             f"{len(starts) - len(bad)} of {len(starts)}",
             f"{sum(warned(f) for f in bad)} of {len(bad)}",
             str(max(f["frames_lost"] for f in seeds)),
             f"{statistics.median(f['time_median_ms'] for f in seeds):.1f}",
             f"{statistics.median(f['time_p995_ms'] for f in seeds):.1f}",
             spread([f["time_max_ms"] for f in seeds])]
    return "| " + " | ".join(cells) + " |"


HEADER = """| sequence | readout [ms] | figure | 5 seeds: median / worst | rotation [deg] | scale error [%] | scale drift, thirds [%] | other starts and half rate: median / worst | their rotation [deg] | of them within twice the must | of the others: warned | frames lost | median [ms] | 99.5 % [ms] | worst [ms]: median / worst |
|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    add_arguments(parser, "real-sequences")
    parser.add_argument("--only", nargs="+", choices=SEQUENCES, default=list(SEQUENCES))
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
