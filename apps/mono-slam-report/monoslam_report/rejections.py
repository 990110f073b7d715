# SPDX-License-Identifier: BSD-3-Clause
"""Which share of the pairs is rejected, over the frames."""
import pandas as pd

from . import panels, style
from .context import Context
from .figures import Figure
from .page import Section
from .results import Cell

STRETCHES = 60


def section(context: Context) -> Section:
    out = Section("Rejections")
    out.say("Left: the share of all pairs that the strategy rejects, all seeds together, a bar for each of at most "
            f"{STRETCHES} stretches of frames. Right: the share of frames in which it rejects anything.")
    context.add_figures(out, lambda cell: draw(context, cell), "No run has frames.csv.")
    return out


def rates(tables: list[pd.DataFrame]) -> pd.DataFrame:
    """Per stretch of frames: rejected share of the pairs, share of frames with a rejection; in percent."""
    table = pd.concat([t.assign(frame=range(len(t))) for t in tables])
    width = max(1, -(-(int(table["frame"].max()) + 1) // STRETCHES))
    groups = table.assign(any=table["rejected"] > 0).groupby(table["frame"] // width)
    pairs = groups["pairs"].sum()
    return pd.DataFrame({"frame": groups["frame"].min(), "width": width,
                         "pairs": 100 * groups["rejected"].sum() / pairs.where(pairs > 0),
                         "frames": 100 * groups["any"].mean()}).fillna(0)


def draw(context: Context, cell: Cell) -> Figure | None:
    strategies = context.results.strategies_of(cell)
    tables = {name: [job.frames for job in context.results.done(cell, name) if job.frames is not None]
              for name in strategies}
    if not any(tables.values()):
        return None
    figure, axes = panels.grid(strategies, ["of the pairs [%]", "of the frames [%]"], "frame")
    totals = []
    for name, found in tables.items():
        if not found:
            panels.say_no_data(axes[name][0])
            continue
        rate = rates(found)
        for axis, what in zip(axes[name], ("pairs", "frames")):
            axis.bar(rate["frame"], rate[what], rate["width"], align="edge", color=context.look.colour(name),
                     alpha=0.8, lw=0)
        together = pd.concat(found)
        totals.append(f"{name} {100 * together['rejected'].sum() / max(1, together['pairs'].sum()):.2g} % of "
                      f"{together['pairs'].sum()} pairs")
    for row in axes.values():
        for axis in row:
            axis.set_ylim(bottom=0)
            axis.spines["bottom"].set_color(style.MUTED)
    return context.figures.save(figure, f"rejections_{cell.name}", f"{cell.title}: rejected in all frames and seeds: "
                                f"{', '.join(totals)}.")
