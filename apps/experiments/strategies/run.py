#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every association strategy in the whole pipeline, as Markdown tables.

    apps/experiments/strategies/run.py [--datasets DIR] [--output DIR] [--only STRATEGY ...] [--jobs N]

Runs the shipped sequence (config/desk.ini) with 20 seeds and, where they exist, the real sequences
(config/default.ini, camera and target as in ../real-sequences) with five, changing only
association.strategy: detection, front end, map management and noise share their seeds. Finished runs
are kept, so that an interrupted call goes on where it was; no run is left out.
"""
import argparse
import concurrent.futures
import os
import statistics
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "common"))
from sequences import (ROOT, SEQUENCES, add_arguments, error, make_rawlog,  # noqa: E402
                       program, readout_s, run_once, settings_as_arguments)

DESK_SEEDS = 20
REAL_SEEDS = 5


def strategies():
    listed = subprocess.run([program("mono-slam"), "--list-strategies"], capture_output=True,
                            text=True, check=True).stdout
    return [line.split("|")[1].strip() for line in listed.splitlines()[2:]]


def desk_run(strategy, seed, args):
    figures = run_once(os.path.join(args.output, f"desk_{strategy}_{seed}"),
                       os.path.join(ROOT, "config", "desk.ini"), None,
                       os.path.join(ROOT, "datasets", "desk", "groundtruth.txt"),
                       ["--seed", str(seed),
                        *settings_as_arguments([f"association.strategy={strategy}"])])
    return figures["SE3_ate_rmse_mm"], figures


def real_run(name, readout, strategy, seed, args):
    settings = [*SEQUENCES[name][3], f"camera.readout_s={readout}",
                f"association.strategy={strategy}"]
    figures = run_once(os.path.join(args.output, f"{name}_{strategy}_{seed}"),
                       os.path.join(ROOT, "config", "default.ini"),
                       os.path.join(args.output, name + ".rawlog"),
                       os.path.join(args.datasets, name, "groundtruth.txt"),
                       ["--seed", str(seed), *settings_as_arguments(settings)])
    return error(name, figures), figures


def row(strategy, runs):
    errors = [value for value, _ in runs]
    figures = [figure for _, figure in runs]
    quarters = statistics.quantiles(errors, n=4, method="inclusive")
    lost = [figure["frames_lost"] for figure in figures]
    cells = [strategy, f"{statistics.median(errors):.2f}", f"{quarters[0]:.2f} to {quarters[2]:.2f}",
             f"{max(errors):.2f}", f"{statistics.median(lost):.0f} / {max(lost)}",
             f"{statistics.median(f['time_median_ms'] for f in figures):.1f}",
             f"{statistics.median(f['time_p995_ms'] for f in figures):.1f}",
             f"{max(f['time_max_ms'] for f in figures):.0f}"]
    return "| " + " | ".join(cells) + " |"


def table(title, unit, count, names, run, args):
    print(f"\n### {title}: {unit}, {count} seeds\n")
    print("| strategy | median | middle half | worst | frames lost: median / worst | "
          "median frame [ms] | 99.5 % [ms] | worst frame [ms] |\n|---|---|---|---|---|---|---|---|")
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        futures = {s: [pool.submit(run, s, seed) for seed in range(1, count + 1)] for s in names}
        for strategy in names:
            print(row(strategy, [f.result() for f in futures[strategy]]), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    add_arguments(parser, "strategies")
    known = strategies()
    parser.add_argument("--only", nargs="+", choices=known, default=known)
    args = parser.parse_args()
    os.makedirs(args.output, exist_ok=True)
    table("desk", "ATE after SE3 [mm]", DESK_SEEDS, args.only,
          lambda strategy, seed: desk_run(strategy, seed, args), args)
    if not os.path.isdir(args.datasets):
        print(f"\nNo real sequences: {args.datasets} is no folder")
        return
    for name, (alignment, *_) in SEQUENCES.items():
        make_rawlog(name, args)
        readout = readout_s(name, args)
        unit = f"ATE after {alignment} [mm]" if alignment else "gap [% of the length]"
        table(name, unit, REAL_SEEDS, args.only,
              lambda strategy, seed: real_run(name, readout, strategy, seed, args), args)


if __name__ == "__main__":
    main()
