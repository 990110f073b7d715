# SPDX-License-Identifier: BSD-3-Clause
"""What Guerra et al. 2013 print, to stand beside what is measured here."""

PAPER = {
    # Average column; the total of the searches that is printed, 2051, is 20 times 102.55.
    "table1": {"frames": 857.53, "seconds": 57.17, "searches": 125.54,
               "searches / frame": 125.54 / 857.53},
    "nodes_per_search": {"jcbb_unbounded": 37575.01, "hohct_printed": 219.37},
    "table3": {"n": 12.08, "r": 1.401},
    "table4": {1: 72.35, 2: 18.08, 3: 6.93, 4: 2.54, 5: 0.15},
    "table5": {"jcbb_unbounded": (52.73, 19.20), "hohct_printed": (24.31, 2.62)},
    "straight_m": 4.0,  # without validation, "from 3 m to about 4 m"
}
