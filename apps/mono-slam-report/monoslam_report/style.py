# SPDX-License-Identifier: BSD-3-Clause
"""One look for all figures: colours that the colour-blind can tell apart, readable in light and dark.

In the page every colour named here is a CSS variable, so that a figure follows the reader's scheme.
"""
import matplotlib

INK, MUTED, GRID = "#24292f", "#59636e", "#d8dee4"
# Okabe and Ito's, without black and yellow: (on paper, on a dark screen).
SERIES = [("#0072b2", "#58b0e6"), ("#d55e00", "#ff9248"), ("#009e73", "#38cf9f"),
          ("#cc79a7", "#e8a5c8"), ("#e69f00", "#f2bd4b"), ("#56b4e9", "#9ad6f7")]
DASHES = ["-", (0, (5, 1.5)), (0, (1.5, 1))]
MARKERS = ["o", "s", "^"]

WIDTH_IN = 7.6  # of every figure


def variables() -> dict[str, tuple[str, str, str]]:
    """CSS variable: (colour in the files, in the light page, in the dark page)."""
    named = {"ink": (INK, INK, "#e6edf3"), "muted": (MUTED, MUTED, "#9aa5b1"), "grid": (GRID, GRID, "#39414b")}
    return named | {f"series{i}": (light, light, dark) for i, (light, dark) in enumerate(SERIES)}


class Look:
    """Colour, dashes and marker of every strategy, the same throughout a report."""

    def __init__(self, strategies: list[str]):
        self._at = {name: i for i, name in enumerate(strategies)}

    def colour(self, strategy: str) -> str:
        return SERIES[self._at[strategy] % len(SERIES)][0]

    def dashes(self, strategy: str):
        return DASHES[self._at[strategy] // len(SERIES) % len(DASHES)]

    def marker(self, strategy: str) -> str:
        return MARKERS[self._at[strategy] // len(SERIES) % len(MARKERS)]


def apply() -> None:
    matplotlib.use("agg")
    matplotlib.rcParams.update({
        "figure.constrained_layout.use": True, "savefig.dpi": 180, "svg.fonttype": "none",
        "svg.hashsalt": "mono-slam-report", "font.size": 10, "axes.titlesize": 10.5,
        "axes.titleweight": "bold", "axes.titlelocation": "left", "axes.labelsize": 9.5,
        "xtick.labelsize": 9, "ytick.labelsize": 9, "legend.fontsize": 9, "legend.frameon": False,
        "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "grid.color": GRID,
        "grid.linewidth": 0.7, "axes.axisbelow": True, "axes.edgecolor": MUTED, "text.color": INK,
        "axes.labelcolor": INK, "axes.titlecolor": INK, "xtick.color": MUTED, "ytick.color": MUTED,
        "xtick.labelcolor": INK, "ytick.labelcolor": INK, "lines.linewidth": 1.6,
        "lines.solid_capstyle": "round", "path.simplify_threshold": 0.3})
