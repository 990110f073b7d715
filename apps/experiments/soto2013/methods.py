# SPDX-License-Identifier: BSD-3-Clause
"""The rows of Table 2: the paper's seven methods with its figures, and ours beside them."""
from typing import NamedTuple


class PaperRow(NamedTuple):
    """Table 2 of the paper: 200 frames of its own sequence, one run each."""
    position_m: float
    orientation_rad: float
    landmark_m: float
    time_ms: float


class Method(NamedTuple):
    strategy: str
    variant: str  # of the batch: what is set besides the strategy
    label: str
    paper: PaperRow | None = None

    @property
    def key(self):
        return self.strategy if self.variant == PLAIN else f"{self.strategy}/{self.variant}"

    @property
    def capped(self):
        return self.variant in CAPPED


PLAIN, SEVERAL, UNBOUNDED = "plain", "several", "unbounded"
CAPPED = (SEVERAL, UNBOUNDED)
MHDA = "mhda"
MRPT = f"jcbb_mrpt/{SEVERAL}"
METHODS = [
    Method("spatial_nn", PLAIN, "Spatial nearest neighbour", PaperRow(0.55381, 0.02576, 5.17722, 40.0957)),
    Method("appearance_nn", PLAIN, "Appearance nearest neighbour", PaperRow(3.72404, 0.11035, 313.843, 35.5125)),
    Method("one_point_ransac", PLAIN, "1-point RANSAC", PaperRow(0.07079, 0.00691, 0.93737, 97.9692)),
    Method("active_search", PLAIN, "Active Search", PaperRow(1.70737, 0.11729, 19.29290, 20.0435)),
    Method("active_matching", PLAIN, "Active Matching", PaperRow(0.28598, 0.010324, 0.97682, 58.621)),
    Method("jcbb_mrpt", SEVERAL, "JCBB (MRPT's), 3 candidates", PaperRow(0.13856, 0.01011, 1.19577, 1380.81)),
    Method(MHDA, PLAIN, "MHDA, P = 2", PaperRow(0.00687, 0.00724, 0.22388, 51.545)),
    Method("jcbb_mrpt", PLAIN, "JCBB (MRPT's), 1 candidate"),
    Method("jcbb", PLAIN, "JCBB (ours)"),
    Method("jcbb", UNBOUNDED, "JCBB without its bound"),
    Method("hohct", PLAIN, "HOHCT"),
    Method("clam", PLAIN, "CLAM"),
    Method("subam", PLAIN, "SubAM"),
]
BY_KEY = {method.key: method for method in METHODS}
STRATEGIES = [method.strategy for method in METHODS if method.variant == PLAIN]


def cap_settings(cap_s, nodes):
    """{variant: settings}: MRPT's search is ended by the clock, ours after a number of nodes, so that
    the same seed gives the same bytes."""
    return {SEVERAL: {"association.jcbb_mrpt.max_candidates": 3,
                      "association.jcbb_mrpt.time_cap_s": cap_s},
            UNBOUNDED: {"association.jcbb.bound": "false", "association.jcbb.node_cap": nodes}}


STRATEGY_OF_VARIANT = {SEVERAL: "jcbb_mrpt", UNBOUNDED: "jcbb"}
