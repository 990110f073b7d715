#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A rendered sequence as a cheap camera would have recorded it. Only what is asked for is done; the order is that of the
light: lens, shutter, exposure, vignetting, gain, noise, JPEG. The result is a sequence like the source."""

import argparse
import json
import shutil
import sys
from pathlib import Path

import cv2
import numpy as np

import sensor_effects as fx
from render import save
from sequence_files import LENS, SequenceFiles


def joined(words):
    """`--distortion -0.2,0.1` as one word: argparse takes -0.2,0.1 for an option."""
    words = list(words)
    for i in reversed([i for i, w in enumerate(words[:-1]) if w == "--distortion"]):
        words[i : i + 2] = ["--distortion=" + words[i + 1]]
    return words


def command_line():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter, prog="render.sh --sensor"
    )
    parser.add_argument("input", type=Path, help="folder of a rendered sequence")
    parser.add_argument("output", type=Path, help="folder that receives the new one")
    parser.add_argument(
        "--distortion",
        default="0,0",
        metavar="K1,K2",
        help="radial distortion; the focal length grows if a barrel needs it",
    )
    parser.add_argument(
        "--rolling-shutter", type=float, default=0.0, metavar="MS", help="time from first to last row [ms]"
    )
    parser.add_argument("--motion-blur", type=float, default=0.0, metavar="MS", help="exposure [ms]")
    parser.add_argument(
        "--vignetting", type=float, default=0.0, metavar="SHARE", help="light lost in the corners, 0 to 1"
    )
    parser.add_argument(
        "--gain",
        type=float,
        default=0.0,
        metavar="SPREAD",
        help="standard deviation of the logarithm of a gain that wanders",
    )
    parser.add_argument(
        "--noise",
        type=float,
        default=0.0,
        metavar="SIGMA",
        help="more noise [grey levels rms]; renders have their own (--noise 0 leaves it away)",
    )
    parser.add_argument(
        "--jpeg", type=int, metavar="QUALITY", help="write JPEG of this quality, 1 to 100, instead of PNG"
    )
    parser.add_argument("--seed", type=int, default=1)
    return parser


def arguments():
    parser = command_line()
    args = parser.parse_args(joined(sys.argv[1:]))
    try:
        args.lens = [float(k) for k in args.distortion.split(",")]
    except ValueError:
        args.lens = []
    if len(args.lens) != 2:
        parser.error(f"--distortion {args.distortion}: two numbers k1,k2")
    if (
        min(args.rolling_shutter, args.motion_blur, args.gain, args.noise, args.seed) < 0
        or not 0 <= args.vignetting < 1
    ):
        parser.error("times, --gain, --noise and --seed must be >= 0, --vignetting at least 0 and below 1")
    if args.jpeg is not None and not 1 <= args.jpeg <= 100:
        parser.error("--jpeg must be 1 to 100")
    return args


def settings(args):
    return {k: v for k, v in sorted(vars(args).items()) if k not in ("input", "output", "distortion")}


def claim(args):
    """Takes the output folder, if it is empty or an earlier run with the same settings is to be finished."""
    path, text = (
        args.output / "sensor.json",
        json.dumps({"input": args.input.resolve().name, **settings(args)}, indent=1) + "\n",
    )
    if args.output.is_dir() and any(args.output.iterdir()) and not (path.is_file() and path.read_text() == text):
        sys.exit(f"{args.output}: is not empty and not the same run; nothing was changed")
    for sub in ("gray", "depth"):
        (args.output / sub).mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def write_tables(files, camera, args, ext):
    values = {k: getattr(camera, k) for k in ("width", "height", "fx", "fy", "cx", "cy")}
    values |= dict(zip(LENS, args.lens + [0, 0, 0])) | {"readout_s": args.rolling_shutter / 1000}
    (args.output / "camera.yaml").write_text("".join(f"{k}: {v:.12g}\n" for k, v in values.items()))
    (args.output / "rgb.txt").write_text(
        "# timestamp filename\n" + "".join(f"{t} gray/{i:04d}.{ext}\n" for i, t in enumerate(files.stamps))
    )
    for name in ("groundtruth.txt", "marks.json"):
        if (files.folder / name).exists():
            shutil.copyfile(files.folder / name, args.output / name)


class Sensor:
    def __init__(self, files, args):
        self.files, self.args = files, args
        self.camera = fx.distorted_camera(files.camera, args.lens) if any(args.lens) else files.camera
        self.at = fx.ideal_pixels(files.camera, self.camera, args.lens)
        self.kept_light = fx.vignetting(self.camera, args.vignetting)
        self.gains = fx.wandering_gain(files.stamps, args.gain, args.seed)

    def frame(self, i):
        """(8-bit picture, 16-bit depth or None)."""
        args, light = self.args, fx.linear_light(self.files.grey(i))
        u, moves = self.at.astype(np.float32), args.rolling_shutter > 0 or args.motion_blur > 0
        if moves:
            interval_ms = 1000 * fx.frame_interval(self.files, i)
            light, u = fx.exposed(
                light,
                self.at,
                fx.Motion(self.files, i),
                args.rolling_shutter / interval_ms,
                args.motion_blur / interval_ms,
            )
        elif any(args.lens):
            light = cv2.remap(light, u[..., 0], u[..., 1], cv2.INTER_CUBIC, borderMode=cv2.BORDER_REPLICATE)
        grey = fx.grey_levels(self.gains[i] * self.kept_light * light) + fx.read_noise(
            light.shape, args.noise, args.seed, i
        )
        depth = None
        if self.files.has_depth(i):
            stored = cv2.imread(str(self.files.depth_path(i)), cv2.IMREAD_UNCHANGED)
            depth = cv2.remap(stored, u[..., 0], u[..., 1], cv2.INTER_NEAREST, borderMode=cv2.BORDER_REPLICATE)
        return np.clip(np.rint(grey), 0, 255).astype(np.uint8), depth


def main():
    args = arguments()
    files = SequenceFiles(args.input)
    if any(files.lens()) or files.yaml.get("readout_s", 0.0):
        sys.exit(f"{args.input}: has passed a sensor already")
    if len(files) < 2:
        sys.exit(f"{args.input}: two frames are needed")
    try:
        sensor = Sensor(files, args)
    except ValueError as error:
        sys.exit(f"--distortion {args.distortion}: {error}")
    claim(args)
    ext, options = ("jpg", {"quality": args.jpeg, "subsampling": 0}) if args.jpeg else ("png", {"optimize": True})
    write_tables(files, sensor.camera, args, ext)
    for i in range(len(files)):
        picture, depth_path = args.output / "gray" / f"{i:04d}.{ext}", args.output / "depth" / f"{i:04d}.png"
        if not picture.exists() or (files.has_depth(i) and not depth_path.exists()):
            grey, depth = sensor.frame(i)
            if depth is not None:
                save(str(depth_path), depth)
            save(str(picture), grey, **options)
        print(f"\r{args.output.name}: {i + 1}/{len(files)}", end="", flush=True)
    print()


if __name__ == "__main__":
    main()
