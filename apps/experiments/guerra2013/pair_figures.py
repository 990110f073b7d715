# SPDX-License-Identifier: BSD-3-Clause
"""Figures 6 and 7: a pair rejected because of a repeated design, and one on a depth step."""
import matplotlib.pyplot as plt
import numpy as np
from causes import match, recorded
from matplotlib.patches import Ellipse
from PIL import Image
from plots import GREEN, ORANGE, RED, save
from problems import depth_frame

HALF_PX = 40  # of the enlarged parts
GATE = 2.448  # sigma of 95 %


def example(judged, kind):
    """The clearest one: not both causes at once, wrong by the exact depth if there is such a one."""
    column, other, rank = (("repeated", "step", "second") if kind == "repeated" else
                           ("step", "repeated", "depth_step"))
    if not len(judged):
        return None
    mine = judged[judged.known & judged[column] & ~judged[other] & ~judged.cut]
    if not len(mine):
        return None
    wrong = mine[mine.wrong]
    return (wrong if len(wrong) else mine).sort_values(
        [rank, "sequence", "frame", "id"], ascending=[False, True, True, True]).iloc[0]


def ellipse(predicted):
    widths, axes = np.linalg.eigh(np.array(predicted["S"]))
    angle = np.degrees(np.arctan2(axes[1, 1], axes[0, 1]))
    size = 2 * GATE * np.sqrt(widths)
    return Ellipse(predicted["h"], size[1], size[0], angle=angle, fill=False, color=ORANGE)


def enlarge(axis, image, centre):
    axis.imshow(image, cmap="gray", vmin=0, vmax=255)
    low = np.clip(centre, HALF_PX, np.array(image.shape[::-1]) - HALF_PX) - HALF_PX
    axis.set(xlim=(low[0], low[0] + 2 * HALF_PX), ylim=(low[1] + 2 * HALF_PX, low[1]), xticks=[],
             yticks=[])
    axis.grid(False)


def draw(pair, sequence, output, name):
    landmarks, _, min_score = recorded(pair.folder, pair.frame)
    landmark = landmarks[pair.id]
    before = match(recorded(pair.folder, depth_frame(pair.frame))[0][pair.id], min_score)[0]
    now = np.array([pair.u, pair.v])
    images = [np.asarray(Image.open(sequence.image(frame)).convert("L"))
              for frame in (depth_frame(pair.frame), pair.frame)]
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.6), layout="constrained",
                                gridspec_kw={"width_ratios": [1, 1, 1.8]})
    enlarge(axes[0], images[0], before)
    axes[0].plot(*before, "*", color=GREEN, markersize=12, markerfacecolor="none")
    axes[0].set_title(f"frame {depth_frame(pair.frame)}: accepted")
    enlarge(axes[1], images[1], landmark["predicted"]["h"])
    axes[1].add_patch(ellipse(landmark["predicted"]))
    for candidate in landmark["candidates"]:
        if candidate["score"] >= min_score and candidate["z"] != list(now):
            axes[1].plot(*candidate["z"], "o", color=ORANGE, markerfacecolor="none")
    axes[1].plot(*now, "*", color=RED, markersize=12,
                 markerfacecolor="none")
    axes[1].set_title(f"frame {pair.frame}: rejected")
    axes[2].imshow(images[1], cmap="gray", vmin=0, vmax=255)
    axes[2].plot(*now, "*", color=RED, markersize=14,
                 markerfacecolor="none")
    axes[2].set(title=sequence.name, xticks=[], yticks=[])
    axes[2].grid(False)
    save(figure, output, name)


def both(judged, sequences, output):
    """Caption of each figure that has an example."""
    by_name = {sequence.name: sequence for sequence in sequences}
    captions = {}
    for name, kind in (("figure6", "repeated"), ("figure7", "step")):
        pair = example(judged, kind)
        if pair is None:
            continue
        draw(pair, by_name[pair.sequence], output, name)
        captions[name] = (
            f"{pair.sequence}, frame {pair.frame}, landmark {pair.id}: {pair.places} other places "
            f"pass the threshold, the surface has a depth step of {100 * pair.depth_step:.0f} %; the match is "
            f"{pair.off_px:.1f} px from where the surface of frame {depth_frame(pair.frame)} is.")
    return captions
