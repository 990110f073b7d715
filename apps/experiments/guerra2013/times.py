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
    first = frames[frames["index"] == 0].groupby("variant").total_ms.median()
    frames = tracked(frames)
    for method in WHOLE_RUNS:
        mine = frames[frames.variant == method.name]
        searched = mine[mine.nodes > 0] if method.strategy != "jcbb_mrpt" else mine[mine.pairs > 0]
        mean, std = PAPER["table5"].get(method.name, (None, None))
        rows.append({"method": method.title, "frames": len(mine), "mean ms": mine.total_ms.mean(),
                     "std ms": mine.total_ms.std(ddof=0), "paper, mean": mean, "paper, std": std,
                     "of it association": mine.associate_ms.mean(),
                     "association in a search": searched.associate_ms.mean(),
                     "99.5 % ms": mine.total_ms.quantile(0.995), "worst ms": mine.total_ms.max(),
                     **{f"% over {limit} ms": 100 * (mine.total_ms > limit).mean()
                        for limit in LIMITS_MS},
                     "first frame, median ms": first[method.name],
                     "searches not finished": int((mine.proved == 0).sum())})
    return Table("table5", "Table 5: time of a frame", rows)
