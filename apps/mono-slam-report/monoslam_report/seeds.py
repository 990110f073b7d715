# SPDX-License-Identifier: BSD-3-Clause
"""Statistics over the seeds of one cell: what a run gives is random, a table of single runs is not.

A value is a number; None and NaN stand for "not measured" and are left out, infinity stands for a run
that failed, which is worse than every number.
"""
import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
from scipy.stats import binomtest


class Summary(NamedTuple):
    """Of the values that were measured; NaN throughout where there is none."""

    median: float
    quartiles: tuple[float, float]
    worst: float
    n: int

    @property
    def iqr(self) -> float:
        lower, upper = self.quartiles
        return 0.0 if lower == upper else upper - lower


class SignTest(NamedTuple):
    """Of pairs with the same seed: how often the first is smaller, larger, equal; two-sided p."""

    wins: int
    losses: int
    ties: int
    p: float


def measured(value: float | None) -> bool:
    return value is not None and not math.isnan(value)


def summary(values: Iterable[float | None]) -> Summary:
    """Median, quartiles (linear interpolation), the value of the largest magnitude, their number."""
    kept = np.sort([float(value) for value in values if measured(value)])
    if not kept.size:
        return Summary(math.nan, (math.nan, math.nan), math.nan, 0)
    lower, median, upper = (between(kept, share) for share in (0.25, 0.5, 0.75))
    return Summary(median, (lower, upper), float(max(kept, key=abs)), int(kept.size))


def between(ordered: np.ndarray, share: float) -> float:
    """The quantile of ordered values; numpy's gives NaN as soon as two of them are infinite."""
    position = share * (ordered.size - 1)
    below, above = ordered[math.floor(position)], ordered[math.ceil(position)]
    return float(below if below == above else below + (position % 1) * (above - below))


def sign_test(a: Sequence[float | None], b: Sequence[float | None]) -> SignTest:
    """Paired test of "a is smaller than b", a[i] and b[i] of the same seed; ties say nothing.

    p is of the exact two-sided binomial test; 1 without any pair that differs. A pair of which one
    was not measured is left out.
    """
    if len(a) != len(b):
        raise ValueError(f"paired values must be equally many, not {len(a)} and {len(b)}")
    pairs = [(x, y) for x, y in zip(a, b) if measured(x) and measured(y)]
    wins = sum(x < y for x, y in pairs)
    losses = sum(x > y for x, y in pairs)
    p = binomtest(wins, wins + losses).pvalue if wins + losses else 1.0
    return SignTest(wins, losses, len(pairs) - wins - losses, float(p))
