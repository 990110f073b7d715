# SPDX-License-Identifier: BSD-3-Clause
"""Tables 1 to 4: how many searches, how large, how many nodes."""
import numpy as np
from cells import Table
from paper import PAPER
from plan import ON_PROBLEMS, PRINTED, TREE, UNBOUNDED


def of(problems, variant):
    return problems[problems.method == variant.name]


def lengths(problems, runs):
    """Table 1. runs: a row a run, frames and seconds."""
    searches = len(of(problems, PRINTED))
    rows = []
    for name, total in (("frames", runs.frames.sum()), ("seconds", runs.seconds.sum()),
                        ("searches", searches), ("searches / frame", np.nan)):
        average = total / len(runs) if name != "searches / frame" else searches / runs.frames.sum()
        rows.append({"": name, "average of a run": average, f"all {len(runs)} runs": total,
                     "paper, average": PAPER["table1"][name]})
    return Table("table1", "Table 1: lengths and searches", rows)


def nodes(problems, runs):
    """Table 2: all methods on the same problems."""
    rows = []
    for method in ON_PROBLEMS:
        mine = of(problems, method).nodes
        rows.append({"method": method.title, "nodes / run": mine.sum() / len(runs),
                     "nodes / frame": mine.sum() / runs.frames.sum(), "nodes / search": mine.mean(),
                     "paper, nodes / search": PAPER["nodes_per_search"].get(method.name),
                     "median": mine.median(), "worst": mine.max()})
    return Table("table2", f"Table 2: nodes of {len(of(problems, PRINTED))} searches", rows)


def work(problems):
    """Beside Table 2: what the nodes cost, and what came of them."""
    key = ["sequence", "seed", "frame"]
    best = of(problems, TREE).set_index(key).accepted
    rows = []
    for method in ON_PROBLEMS:
        mine = of(problems, method)
        accepted = mine.set_index(key).accepted
        rows.append({"method": method.title, "D2 evaluations / search": mine.d2_evaluations.mean(),
                     "ms / search": mine.associate_ms.mean(), "worst ms": mine.associate_ms.max(),
                     "node or subset cap reached": int((mine.proved == 0).sum() - mine.capped.sum()),
                     "time cap reached": int(mine.capped.sum()),
                     "smaller set than HOHCT's": int((accepted < best.reindex(accepted.index)).sum())})
    return Table("table2_work", "Work and outcome of the same searches", rows)


def sizes(problems):
    """Table 3."""
    mine = of(problems, PRINTED)
    rows = [{"": name, "mean": mine[column].mean(), "std": mine[column].std(ddof=0),
             "median": mine[column].median(), "95 %": mine[column].quantile(0.95),
             "most": mine[column].max(), "paper, mean": PAPER["table3"][column]}
            for name, column in (("pairs n", "n"), ("rejected r", "r"))]
    return Table("table3", "Table 3: pairs and rejected pairs of a search", rows)


def rejections(problems, runs):
    """Table 4."""
    mine = of(problems, PRINTED)
    rows = []
    for r in (1, 2, 3, 4, 5, 6):
        hits = int((mine.r == r).sum() if r < 6 else (mine.r >= r).sum())
        rows.append({"pairs rejected": str(r) if r < 6 else "6 or more", "searches": hits,
                     "a run": hits / len(runs), "%": 100 * hits / len(mine),
                     "paper, %": PAPER["table4"].get(r)})
    rows.append({"pairs rejected": "all", "searches": len(mine), "a run": len(mine) / len(runs),
                 "%": 100.0, "paper, %": 100.0})
    return Table("table4", "Table 4: rejected pairs of a search", rows)


def pairs(problems):
    mine = of(problems, PRINTED)
    counts = mine.n.value_counts().sort_index()
    rows = [{"pairs n": str(n), "searches": hits, "%": 100 * hits / len(mine),
             "mean r": mine.r[mine.n == n].mean()} for n, hits in counts.items()]
    return Table("pairs", "Pairs of a search", rows)


def by_sequence(problems, runs, name="by_sequence"):
    rows = []
    for sequence, mine in runs.groupby("sequence", sort=False):
        searches = problems[problems.sequence == sequence]
        printed, unbounded = of(searches, PRINTED), of(searches, UNBOUNDED)
        rows.append({"sequence": sequence, "runs": len(mine), "frames a run": mine.frames.mean(),
                     "searches a run": len(printed) / len(mine),
                     "% of the frames": 100 * len(printed) / mine.frames.sum(),
                     "mean n": printed.n.mean(), "mean r": printed.r.mean(),
                     "HOHCT, printed: nodes / search": printed.nodes.mean(),
                     "JCBB, no bound: nodes / search": unbounded.nodes.mean()})
    return Table(name, "Searches by sequence", rows)


def along_track(problems):
    mine = of(problems, PRINTED)
    tenth = np.minimum((10 * mine.track).astype(int), 9)
    rows = [{"part of the track": f"{10 * k} to {10 * (k + 1)} %",
             "searches": int((tenth == k).sum()), "%": 100 * (tenth == k).mean(),
             "mean r": mine.r[tenth == k].mean()} for k in range(10)]
    return Table("along_track", "Searches along the track", rows)
