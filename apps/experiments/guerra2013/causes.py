# SPDX-License-Identifier: BSD-3-Clause
"""Why pairs were rejected, as far as images and exact depth can tell."""
import functools
import json
from pathlib import Path

import numpy as np
import pandas as pd
from cells import Table
from node_tables import of
from PIL import Image
from plan import PRINTED
from problems import depth_frame
from scipy.spatial.transform import Rotation
from scipy.stats import chi2
from tracks import read

STEP = 0.1  # of the depth
HALF_PATCH_PX = 5  # [search] patch_px = 11
WRONG_PX = 3.0
GATE = chi2.ppf(0.95, 2)  # [association] gate_probability
DEPTH_UNITS = 5000.0  # a metre
RULES = f"""Repeated: another place, {HALF_PATCH_PX} px or more from the match, passes the threshold of a match
in the recorded ellipse of 99.99 %. Cut off: nearer than that, a better place lies outside the ellipse of 95 % that
was searched, so that the match is on its border. On a depth step: in the last frame with depth, the surfaces under
the patch differ by more than {100 * STEP:.0f} % of their depth, as where two edges seem to cross. Wrong: more than
{WRONG_PX:.0f} px from where the surface that the landmark showed in that frame is now, by the exact poses; so is a
pair on a thing that moves."""


def dump_of(folder, frame):
    return Path(folder) / "dump" / f"association_{frame:06d}.json"


@functools.lru_cache(maxsize=64)
def recorded(folder, frame):
    """The landmarks of a dumped problem by their ids, and the camera."""
    problem = json.loads(dump_of(folder, frame).read_text())
    return {landmark["id"]: landmark for landmark in problem["landmarks"]}, problem["camera"], \
        problem["min_score"]


def distance2(landmark, candidate):
    """Mahalanobis, from the prediction."""
    nu = np.array(candidate["z"]) - np.array(landmark["predicted"]["h"])
    return nu @ np.linalg.solve(np.array(landmark["predicted"]["S"]), nu)


def match(landmark, min_score):
    """Pixel and score of the pair that went into validation: the best in the searched ellipse."""
    for candidate in landmark["candidates"] if landmark["predicted"] else []:
        if candidate["score"] >= min_score and distance2(landmark, candidate) < GATE:
            return np.array(candidate["z"]), candidate["score"]
    return None


def others(landmark, pixel, min_score):
    """Far places that look like the landmark as well, and near ones outside the ellipse: scores."""
    far, near = [], []
    for candidate in landmark["candidates"]:
        if np.linalg.norm(np.array(candidate["z"]) - pixel) >= HALF_PATCH_PX:
            far += [candidate["score"]] if candidate["score"] >= min_score else []
        elif distance2(landmark, candidate) >= GATE:
            near.append(candidate["score"])
    return far, near


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
    if not dump_of(folder, before).exists():
        return None  # the first frame, and others without landmarks, have no problem
    image = depth(sequence, before)
    landmark = recorded(folder, before)[0].get(landmark_id)
    found = match(landmark, recorded(folder, before)[2]) if landmark else None
    if image is None or found is None:
        return None
    pixel = found[0]
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
    place, score = match(landmarks[landmark_id], min_score)
    far, near = others(landmarks[landmark_id], place, min_score)
    found = {"sequence": sequence.name, "kind": sequence.kind, "folder": folder, "frame": frame,
             "id": landmark_id, "u": place[0], "v": place[1], "places": len(far),
             "repeated": len(far) > 0, "second": max(far, default=0.0),
             "cut": max(near, default=0.0) > score, "known": False, "step": False, "wrong": False,
             "off_px": np.nan, "depth_step": np.nan}
    under = surface(sequence, folder, frame, landmark_id)
    if under is None:
        return found
    pixel, patch, depth_m = under
    low, high = np.nanpercentile(patch, [5, 95])
    now = seen_again(sequence, camera, pixel, depth_m, (depth_frame(frame), frame))
    off_px = float(np.linalg.norm(now - place))
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
        none = ~known.step & ~known.repeated & ~known.cut
        rows.append({"sequences": name, "rejected pairs": len(mine),
                     "repeated, %": 100 * mine.repeated.mean(), "cut off, %": 100 * mine.cut.mean(),
                     "surface known": len(known), "wrong, %": 100 * known.wrong.mean(),
                     "on a depth step, %": 100 * known.step.mean(),
                     "none of the three, %": 100 * none.mean(),
                     "wrong and none of them, %": 100 * (known.wrong & none).mean()})
    return Table("causes", "Why pairs were rejected", rows)
