# SPDX-License-Identifier: BSD-3-Clause
"""The same methods on the real sequences, where they are present; camera, target and readout as in the README."""
import sys
from pathlib import Path
from types import SimpleNamespace

import pandas as pd

from batches import ROOT, Sequence, by_configuration
from plan import table_batch
from tables import keys_in, label_of, median, short
from worlds import images

sys.path.insert(0, str(ROOT / "apps" / "experiments" / "common"))
import sequences as known  # noqa: E402

# Alignment of the errors; without a target the scale is free, without truth only the gap is known.
ALIGNMENTS = {name: alignment for name, (alignment, *_) in known.SEQUENCES.items()}


def folder():
    """Where the real sequences are, or None."""
    found = Path(known.DATASETS)
    return found if found.is_dir() else None


def batches(datasets, output, size):
    place = SimpleNamespace(datasets=str(datasets), output=str(output / "real"))
    Path(place.output).mkdir(exist_ok=True)
    found = []
    for name, (_, _, _, settings) in known.SEQUENCES.items():
        if not (datasets / name).is_dir():
            continue
        rawlog = Path(known.make_rawlog(name, place))
        truth = datasets / name / "groundtruth.txt"
        pairs = dict(setting.split("=", 1) for setting in settings)
        pairs["camera.readout_s"] = known.readout_s(name, place)
        found.append(Sequence(name, rawlog, truth if truth.is_file() else None, pairs,
                              length=len(images(datasets / name))))
    # With our defaults libs/docs/strategies.md has more seeds of them.
    return by_configuration(table_batch("real", found, size, size.real_seeds), 1)


def table(runs):
    """\\param runs  of one configuration"""
    rows = []
    for name in runs.sequence.unique():
        own, alignment = runs[runs.sequence == name], ALIGNMENTS[name]
        for key in keys_in(own):
            rows.append({"sequence": name, "method": label_of(key),
                         "position": f"{short(median(own, key, 'position_m') * 1e3)} mm ({alignment})" if alignment
                         else f"{short(median(own, key, 'gap_pct'))} % (gap)",
                         "orientation [mrad]": short(median(own, key, "orientation_rad") * 1e3),
                         "ms a frame": short(median(own, key, "frame_ms")),
                         "lost": int((own[own.method == key].lost_frames > 0).sum()),
                         "runs": int((own.method == key).sum())})
    return pd.DataFrame(rows)
