# SPDX-License-Identifier: BSD-3-Clause
"""The paper's Fig. 1: frames before, while and after an object is displaced, as mono-slam draws them."""
import shutil

import matplotlib.pyplot as plt
from PIL import Image

from batches import CONFIGURATIONS, PROGRAMS
from figures import save
from methods import MHDA
from moved_object import outline
from tables import label_of
from worlds import call

MARGIN_PX = 40
METHODS = (MHDA, "active_search", "appearance_nn")


def draw(sequence, strategy, output, seed=1):
    """Folder of the overlays of one run with the paper's settings."""
    folder = output / "pictures" / strategy
    if not (folder / "summary.json").is_file():
        settings = {**sequence.settings, "association.strategy": strategy, "rawlog.frame_count": sequence.frames,
                    "output.associations": "false"}
        shutil.rmtree(folder, ignore_errors=True)
        call(PROGRAMS / "mono-slam", CONFIGURATIONS["paper"], sequence.rawlog, "--output", folder, "--seed", seed,
             "--pictures", *(word for pair in settings.items() for word in ("--set", "=".join(map(str, pair)))))
    return folder / "pictures"


def chosen_frames(first, last, count):
    wanted = [first - 1, (first + last) // 2, last + 1, last + 3 * (last - first + 1)]
    return [min(frame, count - 1) for frame in wanted]


def crop(region, size):
    """Box of the image around the object."""
    (left, top), (right, bottom) = region.vertices.min(axis=0), region.vertices.max(axis=0)
    return (max(left - MARGIN_PX, 0), max(top - MARGIN_PX, 0), min(right + MARGIN_PX, size[0]),
            min(bottom + MARGIN_PX, size[1]))


def montage(sequence, worlds, first, last, output):
    """Rows are methods, columns frames; the part of the image around the object."""
    frames = chosen_frames(first, last, sequence.frames)
    regions = [outline(*worlds, max(frame, first + 2)) or outline(*worlds, last) for frame in frames]
    figure, axes = plt.subplots(len(METHODS), len(frames), figsize=(13, 2.6 * len(METHODS)))
    for row, strategy in zip(axes, METHODS):
        folder = draw(sequence, strategy, output)
        for axis, frame, region in zip(row, frames, regions):
            with Image.open(folder / f"frame_{frame:06d}.jpg") as image:
                axis.imshow(image.crop(crop(region, image.size)))
            axis.set_title(f"frame {frame}", fontsize=8)
            axis.set(xticks=[], yticks=[])
            axis.grid(False)
        row[0].set_ylabel(label_of(strategy))
    save(figure, output / "figures", "recovery_frames")
