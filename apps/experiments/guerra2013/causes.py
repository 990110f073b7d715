# SPDX-License-Identifier: BSD-3-Clause
"""Why pairs were rejected, as far as images and exact depth can tell.

Repeated: two or more places in the search ellipse pass the threshold of a match. On a depth step: in the
last frame that has depth, the surfaces under the patch differ by more than STEP of their depth, as where
two edges seem to cross. Wrong: more than WRONG_PX from where the surface that the landmark showed in that
frame is now, by the exact poses; so is a pair on a thing that moves.
"""
import functools
import json

import numpy as np
import pandas as pd
from cells import Table
from node_tables import of
from PIL import Image
from plan import PRINTED
from problems import depth_frame
from scipy.spatial.transform import Rotation
from tracks import read

STEP = 0.1  # of the depth
HALF_PATCH_PX = 5  # [search] patch_px = 11
WRONG_PX = 3.0
DEPTH_UNITS = 5000.0  # a metre


@functools.lru_cache(maxsize=64)
def recorded(folder, frame):
    """The landmarks of a dumped problem by their ids, and the camera."""
    with open(f"{folder}/dump/association_{frame:06d}.json") as stream:
        problem = json.load(stream)
    return {landmark["id"]: landmark for landmark in problem["landmarks"]}, problem["camera"], \
        problem["min_score"]


@functools.lru_cache(maxsize=8)
def true_poses(sequence):
    """T_world_camera of every image."""
    path = read(sequence.truth)
    nearest = [int(np.argmin(np.abs(path.timestamps - time))) for time in sequence.times]
    return [(path.positions_xyz[i], Rotation.from_quat(path.orientations_quat_wxyz[i],
                                                      scalar_first=True)) for i in nearest]


@functools.lru_cache(maxsize=32)
def depth(sequence, frame):
    """[m], nan where there is none; nothing if the frame has no depth."""
    file = sequence.folder / "depth" / f"{frame:04d}.png"
    if not file.exists():
        return None
    values = np.asarray(Image.open(file), dtype=float) / DEPTH_UNITS
    return np.where(values > 0, values, np.nan)


def surface(sequence, folder, frame, landmark_id):
    """Pixel, depths under the patch, in the last frame with depth that shows the landmark."""
    before = depth_frame(frame)
    image = depth(sequence, before)
    landmark = recorded(folder, before)[0].get(landmark_id)
    if image is None or landmark is None or not landmark["candidates"]:
        return None
    pixel = np.array(landmark["candidates"][0]["z"])
    u, v = np.rint(pixel).astype(int)
    patch = image[max(v - HALF_PATCH_PX, 0):v + HALF_PATCH_PX + 1,
                  max(u - HALF_PATCH_PX, 0):u + HALF_PATCH_PX + 1]
    return (pixel, patch, image[v, u]) if np.isfinite(image[v, u]) else None


def seen_again(sequence, camera, pixel, depth_m, frames):
    """Where what a pixel showed in one frame is in another, by exact depth and poses."""
    focal = np.array([camera["fx_px"], camera["fy_px"]])
    centre = np.array([camera["cx_px"], camera["cy_px"]])
    (r_before, R_before), (r_now, R_now) = (true_poses(sequence)[frame] for frame in frames)
    point = np.append((pixel - centre) / focal, 1.0) * depth_m
    point = R_now.inv().apply(R_before.apply(point) + r_before - r_now)
    return focal * point[:2] / point[2] + centre if point[2] > 0 else np.full(2, np.nan)


def judge(sequence, folder, frame, landmark_id):
    """One rejected pair."""
    landmarks, camera, min_score = recorded(folder, frame)
    candidates = landmarks[landmark_id]["candidates"]
    alike = sorted((c["score"] for c in candidates if c["score"] >= min_score), reverse=True)
    found = {"sequence": sequence.name, "kind": sequence.kind, "folder": folder, "frame": frame,
             "id": landmark_id, "places": len(alike), "repeated": len(alike) > 1,
             "second": alike[1] if len(alike) > 1 else 0.0, "known": False, "step": False,
             "wrong": False, "off_px": np.nan, "depth_step": np.nan}
    under = surface(sequence, folder, frame, landmark_id)
    if under is None:
        return found
    pixel, patch, depth_m = under
    low, high = np.nanpercentile(patch, [5, 95])
    now = seen_again(sequence, camera, pixel, depth_m, (depth_frame(frame), frame))
    off_px = float(np.linalg.norm(now - np.array(candidates[0]["z"])))
    return {**found, "known": bool(np.isfinite(off_px)), "depth_step": (high - low) / low,
            "step": (high - low) / low > STEP, "off_px": off_px, "wrong": off_px > WRONG_PX}


def of_rejected(problems, sequences):
    """A row a pair that the printed HOHCT rejects, in the rendered sequences."""
    by_name = {sequence.name: sequence for sequence in sequences if sequence.marks}
    rows = [judge(by_name[row.sequence], row.folder, row.frame, int(number))
            for row in of(problems, PRINTED).itertuples() if row.sequence in by_name
            for number in row.rejected_ids.split()]
    return pd.DataFrame(rows)


def table(judged):
    rows = []
    groups = [("all", judged)] + list(judged.groupby("kind", sort=False)) if len(judged) else []
    for name, mine in groups:
        known = mine[mine.known]
        step, repeated = known.step, known.repeated
        rows.append({"sequences": name, "rejected pairs": len(mine),
                     "several places pass, %": 100 * mine.repeated.mean(),
                     "surface known": len(known), "wrong, %": 100 * known.wrong.mean(),
                     "on a depth step, %": 100 * step.mean(),
                     "both, %": 100 * (step & repeated).mean(),
                     "neither, %": 100 * (~step & ~repeated).mean(),
                     "wrong and neither, %": 100 * (known.wrong & ~step & ~repeated).mean()})
    return Table("causes", "Why pairs were rejected", rows)
