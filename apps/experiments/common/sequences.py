# SPDX-License-Identifier: BSD-3-Clause
"""The sequences of the experiments, and one run of mono-slam and mono-slam-eval on them."""
import json
import os
import subprocess
import sys

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), *[os.pardir] * 3))
DATASETS = os.environ.get("MONOSLAM_DATASETS", os.path.join(ROOT, os.pardir, "shared", "datasets"))
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


def program(name):
    return os.path.join(os.environ.get("MONOSLAM_PROGRAMS", os.path.join(ROOT, "build", "release", "bin")), name)


def call(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(command)}\n{done.stderr}")


def settings_as_arguments(settings):
    return [word for setting in settings for word in ("--set", setting)]


def add_arguments(parser, output):
    parser.add_argument("--datasets", default=DATASETS)
    parser.add_argument("--output", default=os.path.join(ROOT, "build", output))
    parser.add_argument("--jobs", type=int, default=2)


def error(name, figures):
    """The sequence's own figure: mm after its alignment, or the gap in percent of the length."""
    alignment = SEQUENCES[name][0]
    return figures[f"{alignment}_ate_rmse_mm"] if alignment else figures["gap_pct"]


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
             *settings_as_arguments(settings))
    with open(summary) as stream:
        return round(json.load(stream)["readout_s"], 3)


def run_once(output, config, rawlog, truth, settings):
    """Figures of one run, kept beside it: a run that is finished is not made again.
    rawlog None: the one that the configuration names"""
    figures = os.path.join(output, "figures.json")
    if not os.path.exists(figures):
        call(program("mono-slam"), config, *([rawlog] if rawlog else []), "--output", output,
             "--force", *settings)
        mode = ["--groundtruth", truth] if os.path.exists(truth) else ["--out-and-back"]
        call(program("mono-slam-eval"), *mode, output, "--json", figures + ".part")
        os.replace(figures + ".part", figures)
    with open(figures) as stream:
        return json.load(stream)[0]
