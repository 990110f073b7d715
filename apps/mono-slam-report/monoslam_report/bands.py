# SPDX-License-Identifier: BSD-3-Clause
"""Many runs over one axis as median and band, with no more points than a figure can show."""
from collections.abc import Iterable

import numpy as np
import pandas as pd

POINTS = 240


def band(series: Iterable[tuple[np.ndarray, np.ndarray]], points: int = POINTS) -> pd.DataFrame:
    """Median, quartiles and extremes of all values that fall into each stretch of the axis."""
    table = pd.concat([pd.DataFrame({"at": at, "value": value}) for at, value in series])
    table = table[np.isfinite(table["at"]) & np.isfinite(table["value"])]
    if table.empty:
        return pd.DataFrame(columns=["at", "median", "lower", "upper", "least", "most"])
    step = stretch(table["at"], points)
    groups = table.groupby(np.round((table["at"] - table["at"].min()) / step) if step else table["at"])
    value = groups["value"]
    return pd.DataFrame({
        "at": groups["at"].mean(), "median": value.median(), "lower": value.quantile(0.25),
        "upper": value.quantile(0.75), "least": value.min(), "most": value.max()}).reset_index(drop=True)


def stretch(at: pd.Series, points: int) -> float:
    """The step between frames where there are few of them, else what makes as few stretches."""
    steps = np.diff(np.unique(at))
    if not steps.size:
        return 0.0
    return max(float(np.median(steps)), float(at.max() - at.min()) / points)
