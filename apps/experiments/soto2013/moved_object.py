# SPDX-License-Identifier: BSD-3-Clause
"""Where a displaced object is in the image, what became of the landmarks on it, and who recovers."""
import json

import numpy as np
import pandas as pd
from matplotlib.path import Path as Outline
from monoslam_report.seeds import summary
from PIL import Image
from scipy.spatial import ConvexHull

from quantities import errors_over_time
from tables import keys_in, label_of, median, short

DEPTH_PER_M = 5000.0
CHANGED = 0.01  # relative change of the depth
BEFORE, AFTER = 10, 30  # frames whose median is the error before the movement, and the one that stays
RECOVERED = 2.0  # times the undisturbed error


def moved_frames(folder):
    """(name, first, last) of the object that is displaced."""
    for mark in json.loads((folder / "marks.json").read_text())["objects"]:
        if mark["kind"] == "moved":
            return mark["name"], mark["from_frame"], mark["to_frame"]
    raise ValueError(f"{folder / 'marks.json'}: no object is marked as moved")


def read_depth(folder, frame):
    with Image.open(folder / "depth" / f"{frame:04d}.png") as image:
        return np.asarray(image, dtype=float) / DEPTH_PER_M


def outline(moved, undisturbed, frame):
    """Convex outline of all that the displacement changed in this frame, old place and new; None where
    nothing did. Both worlds are seen from the same poses."""
    one, other = read_depth(moved, frame), read_depth(undisturbed, frame)
    rows, columns = np.nonzero(np.abs(one - other) > CHANGED * np.minimum(one, other))
    points = np.column_stack([columns, rows])
    if len(points) < 20:
        return None
    return Outline(points[ConvexHull(points).vertices])


def outlines(moved, undisturbed):
    """Of every frame in which the object moves."""
    _, first, last = moved_frames(moved)
    found = {frame: outline(moved, undisturbed, frame) for frame in range(first + 1, last + 1)}
    if not any(found.values()):
        raise ValueError(f"{moved}: nothing differs from {undisturbed} in frames {first + 1} to {last}")
    return {frame: region for frame, region in found.items() if region}


def landmarks_on(associations, regions, first):
    """Landmarks born before anything moved and predicted on the object while it does."""
    old, on = set(associations.id[associations["index"] <= first]), set()
    for frame, region in regions.items():
        seen = associations[associations["index"] == frame]
        on |= set(seen.id[region.contains_points(seen[["h_u_px", "h_v_px"]].to_numpy())])
    return old & on


def fates(folder, regions, first, last):
    """Counts over the frames from the first displaced one to the end, of the landmarks on the object."""
    associations = pd.read_csv(folder / "associations.csv")
    on = landmarks_on(associations, regions, first)
    after = associations[associations.id.isin(on) & (associations["index"] > last)]
    during = associations[associations.id.isin(on) & associations["index"].between(first + 1, last)]
    count = after.fate.value_counts()
    return {"on_object": len(on), "matched_during": int((during.fate == "matched").sum()),
            "rejected_during": int((during.fate == "rejected").sum()),
            **{fate: int(count.get(fate, 0)) for fate in ("matched", "rejected", "not_found")},
            "still_alive": int((after["index"] == associations["index"].max()).sum())}


def of_run(folder, first, last):
    """Position error before, at its worst after, and at the end."""
    error = errors_over_time(folder).position_m.to_numpy()
    return {"before_m": np.median(error[max(first - BEFORE, 0):first]),
            "peak_m": error[first:].max(), "end_m": np.median(error[-AFTER:])}


def judge(runs, controls, output, world):
    """A row a run; \\param controls  the same methods and seeds where nothing moves."""
    moved, undisturbed = world
    _, first, last = moved_frames(moved)
    regions = outlines(moved, undisturbed)
    rows = []
    for run in runs[runs.status == "done"].itertuples():
        rows.append({"method": run.method, "seed": run.seed, "lost_frames": run.lost_frames,
                     **of_run(output / run.folder, first, last),
                     **fates(output / run.folder, regions, first, last)})
    judged = pd.DataFrame(rows)
    ends = pd.DataFrame([{"method": run.method, "end_m": of_run(output / run.folder, first, last)["end_m"]}
                         for run in controls[controls.status == "done"].itertuples()])
    judged["control_end_m"] = judged.method.map(ends.groupby("method").end_m.median())
    judged["recovered"] = (judged.lost_frames == 0) & (judged.end_m <= RECOVERED * judged.control_end_m)
    return judged


def table(judged):
    rows = []
    for key in keys_in(judged):
        own = judged[judged.method == key]
        pairs = own.matched.sum() + own.rejected.sum() + own.not_found.sum()
        ends = summary(own.end_m * 1e3)
        rows.append({
            "method": label_of(key), "runs": len(own), "lost track": int((own.lost_frames > 0).sum()),
            "recovered": int(own.recovered.sum()),
            "error before [mm]": short(median(judged, key, "before_m") * 1e3),
            "peak [mm]": short(median(judged, key, "peak_m") * 1e3),
            "end [mm]": short(ends.median), "end, worst [mm]": short(ends.worst),
            "undisturbed end [mm]": short(median(judged, key, "control_end_m") * 1e3),
            "landmarks on the object": short(own.on_object.mean()),
            "accepted, while it moves": short(own.matched_during.mean()),
            "rejected, while it moves": short(own.rejected_during.mean()),
            "afterwards accepted [%]": short(100 * own.matched.sum() / max(pairs, 1)),
            "rejected [%]": short(100 * own.rejected.sum() / max(pairs, 1)),
            "not found [%]": short(100 * own.not_found.sum() / max(pairs, 1)),
            "still in the map": short(own.still_alive.mean())})
    return pd.DataFrame(rows)
