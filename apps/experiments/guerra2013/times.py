# SPDX-License-Identifier: BSD-3-Clause
"""Table 5: time of a frame in whole runs."""
from cells import Table
from paper import PAPER
from plan import WHOLE_RUNS

LIMITS_MS = (40, 33)  # 25 and 30 frames a second


def tracked(frames):
    """Without the first frame of each run."""
    return frames[frames["index"] > 0]


def table5(frames):
    """CPU time of the thread, images decoded already; frames: of all runs."""
    rows = []
    for method in WHOLE_RUNS:
        mine = tracked(frames[frames.variant == method.name]).total_ms
        mean, std = PAPER["table5"].get(method.name, (None, None))
        rows.append({"method": method.title, "frames": len(mine), "mean ms": mine.mean(),
                     "std ms": mine.std(ddof=0), "paper, mean": mean, "paper, std": std,
                     **{f"% over {limit} ms": 100 * (mine > limit).mean() for limit in LIMITS_MS},
                     "worst ms": mine.max()})
    return Table("table5", "Table 5: time of a frame", rows)


def parts(frames):
    """Of the same frames; MRPT's searches in every frame, the others where not all pairs fit."""
    rows = []
    for method in WHOLE_RUNS:
        every = frames[frames.variant == method.name]
        mine = tracked(every)
        rows.append({"method": method.title, "association, mean ms": mine.associate_ms.mean(),
                     "in a search": mine.associate_ms[mine.nodes > 0].mean(),
                     "99.5 % of the frames, ms": mine.total_ms.quantile(0.995),
                     "first frame, median ms": every.total_ms[every["index"] == 0].median(),
                     "searches not finished": int((mine.proved == 0).sum())})
    return Table("table5_parts", "Parts of that time", rows)
