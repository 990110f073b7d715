# SPDX-License-Identifier: BSD-3-Clause
"""The paper's claims, each with a verdict that the numbers give."""
from typing import NamedTuple

import pandas as pd
from scipy.stats import spearmanr

import planes
import sweeps
from methods import BY_KEY, METHODS, MHDA, MRPT
from tables import SIGNIFICANT, keys_in, label_of, median, paired, short

HOLDS, PARTLY, FAILS, OPEN = "holds", "holds in part", "does not hold", "not decided"
SEVEN = [method.key for method in METHODS if method.paper]
SIMILAR = 1.5  # largest ratio of two errors that are called similar
MORE_OFTEN = 2.0  # rejected in one depth third over another that is called a bias
MOST = 0.5
ALIKE = 0.5  # least rank correlation of two orders that are called alike


class Claim(NamedTuple):
    claim: str
    verdict: str
    why: str


class Cells:
    """Runs of Table 2 by configuration and length; the first cell is the paper's own."""

    def __init__(self, cells):
        self.cells = cells
        self.paper = next(iter(cells.values()))

    def values(self, quantity, runs=None):
        runs = self.paper if runs is None else runs
        return {key: median(runs, key, quantity) for key in SEVEN if key in set(runs.method)}

    def rank(self, key, quantity, runs=None):
        values = self.values(quantity, runs)
        return 1 + sum(value < values[key] for value in values.values())

    def ranks(self, key, quantity):
        return ", ".join(f"{self.rank(key, quantity, runs)} ({name})" for name, runs in self.cells.items())


def named(values, unit=1e3, suffix=" mm"):
    ordered = sorted(values.items(), key=lambda item: item[1])
    return ", ".join(f"{label_of(key)} {short(value * unit)}{suffix}" for key, value in ordered)


def best_position(cells):
    values = cells.values("position_m")
    tests = {key: paired(cells.paper, key, MHDA, "position_m") for key in values if key != MHDA}
    better = [key for key, test in tests.items() if test.p < SIGNIFICANT and test.wins > test.losses]
    worse = [key for key, test in tests.items() if test.p < SIGNIFICANT and test.wins < test.losses]
    verdict = HOLDS if cells.rank(MHDA, "position_m") == 1 else FAILS if better else OPEN
    return Claim("MHDA with two particles has the least position error", verdict,
                 f"Medians: {named(values)}. By sign tests over the seeds (p < {SIGNIFICANT}) better than MHDA: "
                 f"{', '.join(map(label_of, better)) or 'none'}; worse: {', '.join(map(label_of, worse)) or 'none'}. "
                 f"MHDA's rank among the paper's seven: {cells.ranks(MHDA, 'position_m')}; "
                 f"after SE3: {cells.ranks(MHDA, 'position_se3_m')}.")


def cheaper(cells):
    times = cells.values("frame_ms")
    rivals = [key for key in ("active_matching", MRPT) if key in times]
    won = [key for key in rivals if times[MHDA] < times[key]]
    verdict = HOLDS if len(won) == len(rivals) else PARTLY if won else FAILS
    return Claim("MHDA costs less than Active Matching and than JCBB", verdict,
                 f"Mean frame, median over the seeds: {named({k: times[k] for k in [MHDA, *rivals]}, 1, ' ms')}.")


def fastest(cells):
    times = cells.values("frame_ms")
    rank = cells.rank("active_search", "frame_ms")
    return Claim("Active Search is the fastest", HOLDS if rank == 1 else FAILS,
                 f"{named(times, 1, ' ms')}. Its rank: {cells.ranks('active_search', 'frame_ms')}.")


def worst_two(cells):
    order = sorted(cells.values("position_m").items(), key=lambda item: item[1])
    last = {key for key, _ in order[-2:]}
    hit = last & {"active_search", "appearance_nn"}
    verdict = HOLDS if len(hit) == 2 else PARTLY if hit else FAILS
    return Claim("Active Search and the appearance nearest neighbour have the largest position errors", verdict,
                 f"The two largest are {' and '.join(f'{label_of(k)} ({short(v * 1e3)} mm)' for k, v in order[-2:])}. "
                 f"Ranks of Active Search: {cells.ranks('active_search', 'position_m')}; "
                 f"of the appearance nearest neighbour: {cells.ranks('appearance_nn', 'position_m')}.")


def depth_planes(cells, pairs):
    key = "one_point_ransac"
    own = planes.shares(pairs).loc[key]
    biased = own.max() > MORE_OFTEN * own.min()
    test = paired(cells.paper, key, MHDA, "landmark_median_m")
    landmarks = [short(1e3 * median(cells.paper, k, "landmark_median_m")) for k in (key, MHDA)]
    verdict = HOLDS if own.max() > MOST else PARTLY if biased else FAILS
    return Claim("1-point RANSAC takes landmarks off the majority's depth plane always as outliers", verdict,
                 f"It rejects {', '.join(f'{short(100 * v)} % of the {name} pairs' for name, v in own.items())}. "
                 f"Holds if it is most in one third, in part if more than {MORE_OFTEN:g} times as many as in another. "
                 f"Median landmark error {landmarks[0]} mm, MHDA {landmarks[1]} mm (1-point RANSAC better in "
                 f"{test.wins} of {test.wins + test.losses} seeds, p {test.p:.2g}).")


def matching_against_jcbb(cells):
    errors, times = cells.values("position_m"), cells.values("frame_ms")
    ratio = errors[MRPT] / errors["active_matching"]
    factor = times[MRPT] / times["active_matching"]
    paper = BY_KEY[MRPT].paper.time_ms / BY_KEY["active_matching"].paper.time_ms
    similar = 1 / SIMILAR < ratio < SIMILAR
    verdict = HOLDS if similar and factor > paper / 2 else PARTLY if similar or factor > 1 else FAILS
    return Claim("Active Matching and JCBB are similarly good, but Active Matching is 26 times faster", verdict,
                 f"JCBB's position error over Active Matching's: {short(ratio)}; its time over that of Active Matching: "
                 f"{short(factor)}. The paper's own table gives {short(paper)}, not 26. Its JCBB is MRPT's, "
                 "which has no joint test and takes exponential time with several candidates.")


def frame_rate(runs):
    rate = sweeps.fps(runs, MHDA)
    return Claim("MHDA runs at about 30 frames a second with 50 features at 480x320",
                 HOLDS if rate >= sweeps.REAL_TIME_FPS else FAILS,
                 f"{short(rate)} frames a second of one core, {short(median(runs, MHDA, 'matched'))} landmarks "
                 f"measured a frame; slowest frame {short(runs[runs.method == MHDA].worst_ms.max())} ms.")


def only_two_in_time(runs):
    rates = {key: sweeps.fps(runs, key) for key in keys_in(runs)}
    slow = [key for key in SEVEN if key in rates and rates[key] < sweeps.REAL_TIME_FPS]
    others = [key for key in SEVEN if key in rates and key not in ("active_matching", MHDA)]
    verdict = HOLDS if set(slow) == set(others) else PARTLY if set(slow) & set(others) else FAILS
    return Claim("Of all methods only Active Matching and MHDA keep up with a camera", verdict,
                 f"Below 30 frames a second of the paper's seven: {', '.join(map(label_of, slow)) or 'none'}. "
                 f"{named(rates, 1, ' fps')}.")


def recovers(judged):
    share = judged.groupby("method").recovered.mean()
    better = [key for key in keys_in(judged) if key != MHDA and share[key] > share[MHDA]]
    runs = judged[judged.method == MHDA]
    verdict = HOLDS if share[MHDA] == 1 and share.drop(MHDA).max() < 1 else PARTLY if share[MHDA] > 0.5 else FAILS
    return Claim("MHDA recovers after an object has been displaced, where others do not", verdict,
                 f"MHDA recovers in {int(runs.recovered.sum())} of {len(runs)} runs; more often: "
                 f"{', '.join(map(label_of, better)) or 'none'}; always: "
                 f"{', '.join(label_of(k) for k in keys_in(judged) if share[k] == 1) or 'none'}.")


def two_particles(points):
    own = points[points.sequence == points.sequence.iloc[0]].set_index("value")
    if 2 not in own.index or len(own) < 3:
        return Claim("Two particles are enough", OPEN, "Too few values of P were run.")
    best = own.position_mm.idxmin()
    verdict = HOLDS if own.position_mm[2] <= SIMILAR * own.position_mm.min() else FAILS
    return Claim("Two particles are enough", verdict,
                 f"Position error {short(own.position_mm[2])} mm with P = 2, least with P = {best:g} "
                 f"({short(own.position_mm[best])} mm); "
                 + ", ".join(f"P = {p:g}: {short(row.position_mm)} mm in {short(row.frame_ms)} ms"
                             for p, row in own.iterrows()) + ".")


def order(cells):
    values = cells.values("position_m")
    test = spearmanr([BY_KEY[key].paper.position_m for key in values], list(values.values()))
    alike = test.statistic > ALIKE
    verdict = HOLDS if alike and test.pvalue < SIGNIFICANT else PARTLY if alike else FAILS
    return Claim("The order of the seven methods by position error", verdict,
                 f"Rank correlation with the paper's: {test.statistic:.2f} (Spearman, p {test.pvalue:.2g}).")


def table(claims):
    return pd.DataFrame([{"claim of the paper": c.claim, "verdict": c.verdict} for c in claims])


def reasons(claims):
    """What decides each of them, as a Markdown list."""
    return "\n".join(f"- **{c.claim}: {c.verdict}.** {c.why}" for c in claims)
