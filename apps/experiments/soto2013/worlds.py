# SPDX-License-Identifier: BSD-3-Clause
"""Rendered sequences as rawlogs: rendered if missing, converted, and once more at the paper's size."""
import json
import shutil
import subprocess
import sys
from pathlib import Path

from PIL import Image

from batches import PROGRAMS, ROOT, Sequence

CAMERA_SCALED = {"fx": 0, "cx": 0, "fy": 1, "cy": 1}  # key: axis


def call(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout[-500:]}{done.stderr}")


def render(folder, names, quick):
    """Frames that are there are kept by the renderer, so that this only fills gaps."""
    only = [word for name in names for word in ("--sequence", name)]
    subprocess.run([ROOT / "datasets" / "render.sh", folder, "--world", "quick" if quick else "office", *only], check=True)


def images(folder):
    """(timestamp, file) of every image, as rgb.txt lists them."""
    lines = (folder / "rgb.txt").read_text().splitlines()
    return [tuple(line.split()[:2]) for line in lines if line and not line.startswith("#")]


def is_complete(folder, frames=0):
    """All images that rgb.txt names, or the first of them, are there, with the truth."""
    if not all((folder / name).is_file() for name in ("rgb.txt", "groundtruth.txt", "marks.json")):
        return False
    listed = images(folder)
    return len(listed) >= max(frames, 1) and all(
        (folder / name).is_file() for _, name in listed[:frames or None])


def rawlog_of(folder, output):
    rawlog = output / "rawlogs" / f"{folder.name}.rawlog"
    if not rawlog.is_file():
        rawlog.parent.mkdir(parents=True, exist_ok=True)
        part = rawlog.parent / "part" / rawlog.name  # the images' folder is named after the rawlog
        shutil.rmtree(part.parent, ignore_errors=True)
        part.parent.mkdir()
        call(PROGRAMS / "images2rawlog", "--format", "tum", "--input", folder, "--camera",
             folder / "camera.yaml", "--groundtruth", folder / "groundtruth.txt", "--output", part)
        images = f"{folder.name}_Images"
        shutil.rmtree(rawlog.parent / images, ignore_errors=True)
        (part.parent / images).rename(rawlog.parent / images)
        part.rename(rawlog)
    return rawlog


def target_settings(folder):
    """The metric start by the dark rectangle that lies in view of the first frame."""
    width, height = json.loads((folder / "marks.json").read_text())["target"]["rectangle_size_m"]
    return {"metric_start.method": "rectangle", "metric_start.rectangle_size_m": f"{width} {height}"}


def sequence_of(folder, output, frames=0, **settings):
    depth = folder / "depth"
    return Sequence(f"{folder.name}_{frames}" if frames else folder.name, rawlog_of(folder, output),
                    folder / "groundtruth.txt",
                    {**target_settings(folder),
                     **{key.replace("__", "."): value for key, value in settings.items()}},
                    depth if depth.is_dir() else None, frames)


def resized(folder, output, size, frames):
    """The first frames at another size, by the mean of the pixels that a new one covers; focal length
    and principal point are scaled along each axis, so that pixels need not stay square."""
    small = output / f"{folder.name}_{size[0]}x{size[1]}"
    if is_complete(small, frames):
        return small
    (small / "gray").mkdir(parents=True, exist_ok=True)
    listed = [(t, name, f"gray/{Path(name).stem}.png") for t, name in images(folder)[:frames]]
    for _, name, new_name in listed:
        with Image.open(folder / name) as image:
            old_size = image.size
            image.convert("L").resize(size, Image.Resampling.BOX).save(small / new_name)
    ratio = [new / old for new, old in zip(size, old_size)]
    (small / "camera.yaml").write_text(scaled_camera((folder / "camera.yaml").read_text(), size, ratio))
    for name in ("groundtruth.txt", "marks.json"):
        shutil.copyfile(folder / name, small / name)
    (small / "rgb.txt").write_text("".join(f"{t} {name}\n" for t, _, name in listed))
    return small


def scaled_camera(text, size, ratio):
    """Of a camera.yaml; the centre of the first pixel is (0, 0)."""
    lines = []
    for line in text.splitlines():
        key, _, value = line.partition(":")
        if key in ("width", "height"):
            value = f" {size[key == 'height']}"
        elif key in CAMERA_SCALED:
            scale = ratio[CAMERA_SCALED[key]]
            value = f" {float(value) * scale if key[0] == 'f' else (float(value) + 0.5) * scale - 0.5:.6f}"
        lines.append(f"{key}:{value}" if key.strip() and not key.startswith("#") else line)
    return "\n".join(lines) + "\n"
