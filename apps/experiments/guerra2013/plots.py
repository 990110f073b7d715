# SPDX-License-Identifier: BSD-3-Clause
"""What all figures share: colours that colour-blind readers can tell apart, files as SVG and PNG."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from plan import BOUNDED, MRPT, NONE, PRINTED, TREE, UNBOUNDED  # noqa: E402

BLUE, ORANGE, GREEN, RED, PURPLE, GREY = ("#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7",
                                          "#666666")
COLOURS = {PRINTED.name: BLUE, UNBOUNDED.name: RED, TREE.name: GREEN, BOUNDED.name: ORANGE,
           MRPT.name: GREY, NONE.name: RED}
plt.rcParams.update({"axes.grid": True, "grid.alpha": 0.25, "axes.spines.top": False,
                     "axes.spines.right": False, "legend.frameon": False, "font.size": 10,
                     "svg.hashsalt": "monoslam"})  # same input, same bytes


def save(figure, output, name):
    folder = output / "figures"
    folder.mkdir(parents=True, exist_ok=True)
    figure.savefig(folder / f"{name}.svg", bbox_inches="tight", metadata={"Date": None})
    figure.savefig(folder / f"{name}.png", bbox_inches="tight", dpi=130)
    plt.close(figure)
