# SPDX-License-Identifier: BSD-3-Clause
"""The rendered and the real sequences, and their rawlogs."""
import json
import os
import shutil
import sys
from dataclasses import dataclass, field
from pathlib import Path

from plan import ROOT
from programs import call, program

sys.path.insert(0, str(ROOT / "apps" / "experiments" / "common"))
from sequences import SEQUENCES  # noqa: E402


@dataclass(frozen=True)
class Sequence:
    name: str
    folder: Path
    times: tuple  # [s], of the images
    settings: dict = field(default_factory=dict, compare=False)
    marks: dict | None = field(default=None, compare=False)  # of rendered ones

    @property
    def frames(self):
        return len(self.times)

    @property
    def kind(self):
        """uturn, turn, rails, corridor; of real ones their name."""
        return self.name.split("_")[1] if self.marks else self.name

    @property
    def truth(self):
        file = self.folder / "groundtruth.txt"
        return file if file.exists() else None

    def image(self, frame):
        return self.folder / images_of(self.folder)[frame][1]


def images_of(folder):
    """(time, file) of each image."""
    lines = (folder / "rgb.txt").read_text().splitlines()
    rows = [line.split() for line in lines if line.strip() and not line.startswith("#")]
    return [(float(row[0]), row[1]) for row in rows]


def what_is_missing(folder):
    """Of a sequence that is still being rendered; nothing if it is complete."""
    for name in ("rgb.txt", "groundtruth.txt", "camera.yaml", "marks.json"):
        if not (folder / name).exists():
            return f"no {name}"
    absent = [file for _, file in images_of(folder) if not (folder / file).exists()]
    return f"{len(absent)} images not yet there" if absent else None


def rendered(worlds, names):
    """The complete ones, and what the others lack by their names."""
    complete, missing = [], {}
    for name in names:
        folder = worlds / name
        lack = what_is_missing(folder) if folder.is_dir() else "not there"
        if lack:
            missing[name] = lack
            continue
        marks = json.loads((folder / "marks.json").read_text())
        width, height = marks["target"]["rectangle_size_m"]
        settings = {"metric_start.method": "rectangle",
                    "metric_start.rectangle_size_m": f"{width} {height}"}
        times = tuple(time for time, _ in images_of(folder))
        complete.append(Sequence(name, folder.resolve(), times, settings, marks))
    return complete, missing


def real(datasets):
    """Those of the shared datasets that are there; a target is named where one lies in view."""
    found = []
    for name, (*_, settings) in SEQUENCES.items():
        folder = datasets / name
        if (folder / "rgb.txt").exists():
            found.append(Sequence(name, folder.resolve(),
                                  tuple(time for time, _ in images_of(folder)),
                                  dict(setting.split("=", 1) for setting in settings)))
    return found


def make_rawlog(sequence, output):
    """Its rawlog, in a folder of its own that is renamed when all images are in it."""
    folder = output / "rawlogs" / sequence.name
    rawlog = folder / f"{sequence.name}.rawlog"
    listed = sequence.folder / "rgb.txt"
    if rawlog.exists() and rawlog.stat().st_mtime >= listed.stat().st_mtime:
        return rawlog
    part = folder.with_name(folder.name + ".part")
    for old in (part, folder):
        shutil.rmtree(old, ignore_errors=True)
    part.mkdir(parents=True)
    truth = ["--groundtruth", sequence.truth] if sequence.truth else []
    call(program("images2rawlog"), "--format", "tum", "--input", sequence.folder, "--camera",
         sequence.folder / "camera.yaml", "--output", part / rawlog.name, *truth)
    os.replace(part, folder)
    return rawlog
