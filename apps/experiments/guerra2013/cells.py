# SPDX-License-Identifier: BSD-3-Clause
"""Tables: as CSV for the report, as Markdown for the documentation."""
import math
from dataclasses import dataclass

import pandas as pd
from programs import write_text


def text(value):
    """A cell: four digits, no exponent, a dash for what was not measured, inf for a failed run."""
    if isinstance(value, str):
        return value
    if value is None or pd.isna(value):
        return "-"
    if math.isinf(value):
        return "inf"
    if float(value).is_integer():
        return str(int(value))
    digits = 4 - len(str(int(abs(value)))) if abs(value) >= 1 else 4
    return f"{value:.{max(digits, 1)}f}"


@dataclass
class Table:
    name: str
    title: str
    rows: list  # of dicts with the same keys
    note: str = ""

    @property
    def cells(self):
        return pd.DataFrame([{key: text(value) for key, value in row.items()} for row in self.rows])

    def write(self, output):
        write_text(output / "tables" / f"{self.name}.csv", self.cells.to_csv(index=False))

    def markdown(self):
        cells = self.cells
        words = [any(isinstance(row[key], str) for row in self.rows) for key in cells.columns]
        rule = "|" + "|".join("---" if word else "--:" for word in words) + "|\n"
        lines = ["| " + " | ".join(row) + " |\n" for row in (cells.columns, *cells.to_numpy())]
        return lines[0] + rule + "".join(lines[1:])
