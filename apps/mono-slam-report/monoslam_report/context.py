# SPDX-License-Identifier: BSD-3-Clause
"""What every section needs: the runs, where figures go, how much is drawn."""
from collections.abc import Callable
from dataclasses import dataclass

from .figures import Figure, FigureFolder
from .page import Section
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
        """A figure a cell; says what is left out, or why there is none."""
        drawn = 0
        for cell in self.drawn_cells():
            figure = draw(cell)
            if figure is not None:
                section.blocks.append(figure)
                drawn += 1
        if not drawn:
            section.say(f"*{nothing}*")
        left = len(self.results.cells) - self.most_cells
        if drawn and left > 0:
            section.say(f"Drawn for the first {self.most_cells} sequences and variants; {left} more are in the "
                        "tables (`--cells N` draws N).")
