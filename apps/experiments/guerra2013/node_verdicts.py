# SPDX-License-Identifier: BSD-3-Clause
"""The paper's claims on searches, nodes and time, each with the numbers that decide it."""
import numpy as np
from cells import text
from cost import FITTED, LEAST, equation_14, equation_15, exponents, hohct_leaves, over
from node_tables import of
from paper import PAPER
from plan import BOUNDED, PRINTED, TREE, UNBOUNDED
from scipy.stats import binomtest
from times import tracked
from verdicts import FAILS, HOLDS, OPEN, PART, SURE, Verdict, counted

KEY = ["sequence", "seed", "frame"]


@counted
def seldom(problems, runs, **_):
    share = len(of(problems, PRINTED)) / runs.frames.sum()
    return Verdict("A search is needed in less than 1/7 of the frames",
                   HOLDS if share < 1 / 7 else FAILS,
                   f"{100 * share:.1f} % of {runs.frames.sum()} frames",
                   "The paper's own 125.54 searches in 857.53 frames are 14.6 %, more than 1/7; its "
                   "other count, 102.34, is 11.9 %.")


@counted
def late(problems, **_):
    track = of(problems, PRINTED).track
    second = int((track >= 0.5).sum())
    p = binomtest(second, len(track)).pvalue
    verdict = HOLDS if p < SURE and second > len(track) / 2 else FAILS if p < SURE else OPEN
    return Verdict("Most incompatibilities come towards the end of a track", verdict,
                   f"{second} of {len(track)} searches lie in the second half of the frames, p = {p:.2g}")


@counted
def mostly_one(problems, **_):
    r = of(problems, PRINTED).r
    one = 100 * (r == 1).mean()
    return Verdict("Most searches reject one pair; the more, the rarer",
                   HOLDS if one > 50 and (r == 1).sum() > (r == 2).sum() > (r == 3).sum() else
                   PART if one > 50 else FAILS,
                   f"one pair in {one:.1f} % (paper: {PAPER['table4'][1]} %), mean r {r.mean():.2f} "
                   f"(paper: {PAPER['table3']['r']}), most {r.max()}")


@counted
def advantage(problems, **_):
    fitted = problems[problems.method.isin([m.name for m in FITTED])]
    ended = fitted.groupby(KEY).proved.transform("min") == 1
    mean = {m.name: of(fitted[ended], m).nodes.mean() for m in FITTED}
    paper = PAPER["nodes_per_search"]
    against = mean[UNBOUNDED.name] / mean[PRINTED.name]
    fair = mean[BOUNDED.name] / mean[PRINTED.name]
    return Verdict("HOHCT builds 171 times fewer nodes than JCBB",
                   (HOLDS if fair >= 10 else PART) if against >= 10 else FAILS,
                   f"{against:.1f} times against JCBB without its bound (paper: "
                   f"{paper[UNBOUNDED.name] / paper[PRINTED.name]:.0f}), {fair:.2f} times against JCBB "
                   f"with it; HOHCT as a branch and bound: "
                   f"{mean[BOUNDED.name] / mean[TREE.name]:.2f} times fewer than that JCBB; over the "
                   f"{ended.sum() // len(FITTED)} searches in which none reached its cap",
                   "The paper's JCBB goes on after a compatible set has been found and cuts only "
                   "incompatible branches. The textbook's JCBB leaves a branch that cannot have more "
                   "pairs than the best set so far. The paper calls its factor of 171 three orders of "
                   "magnitude.")


@counted
def twenty_two(problems, **_):
    mean = of(problems, PRINTED).nodes.mean()
    return Verdict("An average HOHCT search explores about 22 nodes", HOLDS if 11 < mean < 44 else
                   FAILS, f"{mean:.1f} nodes a search (paper's Table 2: "
                   f"{PAPER['nodes_per_search'][PRINTED.name]})",
                   "In the paper 26 is the number a frame; a search has 219 in its Table 2.")


@counted
def linear(problems, **_):
    rows = {row["method"]: row for row in exponents(problems).rows}
    k, one = rows[PRINTED.title]["all"], rows[PRINTED.title]["r = 1"]
    verdict = OPEN if np.isnan(k) else HOLDS if k < 1.5 else FAILS
    return Verdict("On average HOHCT's cost is almost linear in n", verdict,
                   f"nodes ~ n^k over all searches: k = {text(k)}; with r = 1: k = {text(one)}",
                   "Each rejected pair adds about one to the exponent, so that the average depends on "
                   "how many there are.")


@counted
def exponential(problems, **_):
    mine = of(problems, UNBOUNDED)
    mine = mine[mine.proved == 1]
    ratio = mine.leaves.sum() / equation_14(mine.n, mine.r).sum() if len(mine) else np.nan
    return Verdict("Eq. 14 gives the leaves of JCBB", OPEN if len(mine) < LEAST else
                   HOLDS if 0.5 < ratio < 2 else FAILS,
                   f"counted / eq. 14 = {text(ratio)} over {len(mine)} searches that ended; all nodes "
                   f"are {text(mine.nodes.sum() / max(mine.leaves.sum(), 1))} times the leaves",
                   "Eq. 14 is 2^(n-r). It describes the search without the bound only.")


@counted
def overcount(problems, **_):
    mine = of(problems, PRINTED)
    mine = mine[mine.proved == 1]
    counted = mine.leaves.mean()
    right, paper = over(hohct_leaves, mine), over(equation_15, mine)
    return Verdict("Eq. 15 gives the leaves of HOHCT", HOLDS if abs(paper / counted - 1) < 0.1 else
                   FAILS, f"counted {counted:.1f} a search, sum C(n,i) = {right:.1f}, eq. 15 = "
                   f"{paper:.1f}", "Eq. 15 counts ordered choices with repetition; there are C(n,i) "
                   "subsets.")


@counted
def worst_case(problems, **_):
    worst, mean = of(problems, PRINTED).nodes.max(), of(problems, UNBOUNDED).nodes.mean()
    return Verdict("HOHCT's worst case is about JCBB's average", HOLDS if worst <= 2 * mean else
                   FAILS, f"worst HOHCT search {worst} nodes, average JCBB search without bound "
                   f"{mean:.0f}")


@counted
def same_sets(problems, **_):
    best = of(problems, TREE).set_index(KEY)
    mine = of(problems, UNBOUNDED)
    mine = mine[mine.proved == 1].set_index(KEY)
    best = best.reindex(mine.index)
    same = int((best.rejected_ids == mine.rejected_ids).sum())
    fewer = int((mine.accepted < best.accepted).sum())
    return Verdict("JCBB tries all hypotheses and so finds the best; its order does not matter",
                   FAILS if fewer else HOLDS if same == len(mine) else PART,
                   f"the same set as HOHCT in {same} of {len(mine)} searches, a smaller one in {fewer}",
                   "A prefix of a compatible set can be incompatible, because the limit grows with "
                   "the number of pairs: JCBB then cuts the branch that holds the answer.")


@counted
def time_of_frame(frames, **_):
    frames = tracked(frames)
    total = {m.name: frames.total_ms[frames.variant == m.name] for m in (PRINTED, UNBOUNDED)}
    mean = {name: values.mean() for name, values in total.items()}
    std = {name: values.std(ddof=0) for name, values in total.items()}
    ratio = mean[UNBOUNDED.name] / mean[PRINTED.name]
    paper = PAPER["table5"]
    return Verdict("With JCBB a frame takes twice the time, and varies much more",
                   HOLDS if ratio >= 1.8 and std[UNBOUNDED.name] > 2 * std[PRINTED.name] else
                   PART if ratio > 1.1 or std[UNBOUNDED.name] > 2 * std[PRINTED.name] else FAILS,
                   f"mean {mean[UNBOUNDED.name]:.2f} against {mean[PRINTED.name]:.2f} ms, a factor of "
                   f"{ratio:.2f} (paper: {paper[UNBOUNDED.name][0] / paper[PRINTED.name][0]:.2f}); std "
                   f"{std[UNBOUNDED.name]:.2f} against {std[PRINTED.name]:.2f} ms",
                   "JCBB here has no bound, as in the paper.")


@counted
def real_time(frames, **_):
    mine = tracked(frames).total_ms[frames.variant == PRINTED.name]
    shares = {limit: 100 * (mine > limit).mean() for limit in (67, 40, 33)}
    return Verdict("With HOHCT real time at 15 and 25 frames a second, at 30 it is doubtful",
                   HOLDS if shares[40] < 0.1 <= shares[33] else PART if shares[40] < 0.1 else FAILS,
                   ", ".join(f"{share:.2f} % of the frames over {limit} ms"
                             for limit, share in shares.items()),
                   "On a processor of today 30 frames a second are no question either."
                   if shares[33] < 0.1 else "")


ALL = (seldom, late, mostly_one, advantage, twenty_two, linear, exponential, overcount,
            worst_case, same_sets, time_of_frame, real_time)
