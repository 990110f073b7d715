#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Path errors of kf-slam-joint on MRPT's sample rawlog, clean and with clutter, as a Markdown table.

    apps/experiments/kf-slam/run.py [--seeds N] [--output DIR] [--time-limit SECONDS] [--only METHOD ...]
                                    [--into libs/docs/mrpt.md]

Needs the Debian packages mrpt-common (rawlog, truth, ini) and mrpt-apps (kf-slam itself), and a build
with MONOSLAM_BUILD_EXPERIMENTS=ON. Finished runs are kept, so that an interrupted call goes on.
"""
import argparse
import concurrent.futures
import math
import os
import re
import resource
import signal
import statistics
import subprocess
import sys

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), *[os.pardir] * 3))
MRPT = "/usr/share/mrpt"
INI = os.path.join(MRPT, "config_files", "kf-slam", "EKF-SLAM_6D_test_datassoc.ini")
RAWLOG = os.path.join(MRPT, "datasets", "kf-slam_6D_demo_DA.rawlog")
TRUTH = os.path.join(MRPT, "datasets", "kf-slam_6D_demo_DA_ground_truth_robot_path.txt")

# name: settings of kf-slam-joint besides data_assoc_method
METHODS = {
    "JCBB_MRPT": ("JCBB_MRPT", []),
    "JCBB_MRPT, forgets": ("JCBB_MRPT", ["RangeBearingKFSLAM_Joint.remove_missed=true"]),
    "NN": ("NN", []),
    "JCBB": ("JCBB", []),
    "JCBB, keeps": ("JCBB", ["RangeBearingKFSLAM_Joint.remove_missed=false"]),
    "HOHCT": ("HOHCT", []),
    "MHDA": ("MHDA", []),
}
# kind and mean number of false observations a frame; see experiment-kf-slam
CLUTTER = [("uniform", 0.0), ("uniform", 1.0), ("uniform", 3.0), ("echo", 1.0), ("echo", 2.0)]


def program(name):
    return os.path.join(ROOT, "build", "release", "bin", name)


def call(command, **more):
    return subprocess.run(command, capture_output=True, text=True, **more)


def spoiled(clutter, seed, args):
    """The rawlog with clutter of that seed."""
    kind, mean = clutter
    if not mean:
        return RAWLOG
    rawlog = os.path.join(args.output, f"{kind}_{mean}_{seed}.rawlog")
    if not os.path.exists(rawlog):
        done = call([program("experiment-kf-slam"), RAWLOG, rawlog, kind, str(mean), str(seed)])
        if done.returncode:
            sys.exit(done.stderr)
    return rawlog


def number(pattern, text):
    return float(re.search(pattern + r" ([-+.\deinfa]+)", text)[1])


def run(method, clutter, seed, args):
    """RMSE [m], longest step [ms] and landmarks at the end, or None if the time limit ended it."""
    association, settings = METHODS[method]
    output = os.path.join(args.output, f"{clutter[0]}_{clutter[1]}_{seed}_{method.replace(', ', '_')}")
    log = output + ".txt"
    if not os.path.exists(log):
        settings = [f"RangeBearingKFSLAM.data_assoc_method={association}",
                    "MappingApplication.SAVE_LOG_FREQUENCY=1000", *settings]
        done = call([program("kf-slam-joint"), INI, spoiled(clutter, seed, args), "--output", output,
                     "--force", "--seed", str(seed), *[w for s in settings for w in ("--set", s)]],
                    preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (args.time_limit,) * 2))
        ended = done.returncode in (-signal.SIGXCPU, -signal.SIGKILL)
        if done.returncode and not ended:
            sys.exit(done.stderr)
        with open(log, "w") as stream:
            stream.write("" if ended else done.stdout)
    with open(log) as stream:
        text = stream.read()
    if not text:
        return None
    return number("path: RMSE", text), number("the longest", text), number("landmarks:", text)


def rows(file):
    """Numbers of a text matrix of MRPT."""
    with open(file) as stream:
        return [[float(w) for w in line.split()] for line in stream
                if line.strip() and not line.startswith("%")]


def kf_slam_rmse(args):
    """RMSE of kf-slam's own robot_pose files, by the frames of the truth and row by row."""
    folder = os.path.join(args.output, "kf-slam")
    os.makedirs(folder, exist_ok=True)
    ini = os.path.join(folder, "kf-slam.ini")
    with open(INI) as stream:
        text = stream.read().replace("../..", MRPT)
    with open(ini, "w") as stream:
        stream.write(re.sub(r"SHOW_3D_LIVE\s*=\s*true", "SHOW_3D_LIVE=false", text))
    done = call(["kf-slam", ini, RAWLOG], cwd=folder)
    if done.returncode:
        sys.exit(done.stdout + done.stderr)
    out = os.path.join(folder, "LOG_EKF-SLAM")
    truth = rows(TRUTH)
    poses = [[row[0] for row in rows(os.path.join(out, name))][:3]
             for name in sorted(os.listdir(out)) if name.startswith("robot_pose")]

    def rmse(skipped):
        errors = [math.dist(p, q[:3])**2 for p, q in zip(poses, truth[skipped:])]
        return math.sqrt(sum(errors) / len(errors))
    return rmse(len(truth) - len(poses)), rmse(0)


def row(name, runs):
    good = [r for r in runs if r]
    if not good:
        return f"| {name} | - | - | - | - | {len(runs)} of {len(runs)} |"
    rmse = [r[0] for r in good]
    return (f"| {name} | {statistics.median(rmse):.4f} | {max(rmse):.4f} | "
            f"{statistics.median(r[1] for r in good):.1f} | {statistics.median(r[2] for r in good):.0f} | "
            f"{len(runs) - len(good)} of {len(runs)} |")


HEADER = """| association | path RMSE, median [m] | worst [m] | longest step, median [ms] | landmarks | over the time limit |
|---|---|---|---|---|---|"""


def replace_table(page, table):
    """What stands between the two comments of the page."""
    begin, end = "<!-- written by apps/experiments/kf-slam/run.py -->\n", "<!-- end -->"
    with open(page) as stream:
        before, rest = stream.read().split(begin)
    after = rest.split(end)[1]
    with open(page, "w") as stream:
        stream.write(before + begin + table + "\n" + end + after)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--seeds", type=int, default=10)
    parser.add_argument("--output", default=os.path.join(ROOT, "build", "kf-slam"))
    parser.add_argument("--time-limit", type=int, default=60, help="CPU time of a run [s]")
    parser.add_argument("--only", nargs="+", choices=METHODS, default=list(METHODS))
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--into", help="also replace the table of this page")
    args = parser.parse_args()
    if not os.path.exists(RAWLOG):
        sys.exit(f"{RAWLOG}: missing; it is in the package mrpt-common")
    os.makedirs(args.output, exist_ok=True)
    lines = []

    def write(line):
        lines.append(line)
        print(line, flush=True)

    by_frame, by_row = kf_slam_rmse(args)
    write(f"kf-slam itself, without clutter: {by_frame:.4f} m ({by_row:.4f} m if its first pose, which is of\n"
          "the second frame, is compared with the first row of the truth). "
          f"Time limit: {args.time_limit} s of CPU time a run.")
    for clutter in CLUTTER:
        kind, mean = clutter
        what = f"{mean:g} {kind} false observation{'s' if mean > 1 else ''} a frame" if mean else "No clutter"
        write(f"\n**{what}**\n\n{HEADER}")
        for method in args.only:
            seeds = range(1, (args.seeds if mean or method == "MHDA" else 1) + 1)
            for seed in seeds:
                spoiled(clutter, seed, args)
            with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
                runs = list(pool.map(lambda seed: run(method, clutter, seed, args), seeds))
            write(row(method, runs))
    if args.into:
        replace_table(args.into, "\n".join(lines))


if __name__ == "__main__":
    main()
