# SPDX-License-Identifier: BSD-3-Clause
"""What every section needs: the runs, where figures go, how much is drawn."""
from collections.abc import Callable
from dataclasses import dataclass

from .figures import Figure, FigureFolder
from .page import Fold, Section
from .results import Cell, Results
from .style import Look


@dataclass
class Context:
    results: Results
    figures: FigureFolder
    look: Look
    reference: str
    most_cells: int = 6  # sequences (under one variant) that get figures; tables have all
    most_paths: int = 3  # runs of a strategy drawn as single lines

    def drawn_cells(self) -> list[Cell]:
        return self.results.cells[:self.most_cells]

    def add_figures(self, section: Section, draw: Callable[[Cell], Figure | None], nothing: str) -> None:
        """A figure a cell, the first of them open; says what is left out, or why there is none."""
        drawn = [(cell, figure) for cell in self.drawn_cells() if (figure := draw(cell)) is not None]
        if not drawn:
            section.say(f"*{nothing}*")
        elif len(drawn) == 1:
            section.blocks.append(drawn[0][1])
        else:
            section.blocks += [Fold(cell.title, figure, opened=i == 0) for i, (cell, figure) in enumerate(drawn)]
        left = len(self.results.cells) - self.most_cells
        if drawn and left > 0:
            section.say(f"Sequences and variants without a figure: {left} of {len(self.results.cells)}; they are in the "
                        "tables, and `--cells N` draws N.")
