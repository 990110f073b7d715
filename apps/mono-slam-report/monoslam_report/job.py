# SPDX-License-Identifier: BSD-3-Clause
"""The files of one run, read when first asked for. What is missing or damaged is None and a note."""
import math
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import pandas as pd

from .track import Track, track_from_errors, track_of

UNUSED = {"state", "remark", "prepare_ms", "predict_ms", "search_ms", "update_ms", "map_ms", "decode_ms", "candidates",
          "visible", "mean_nis", "residual_rms_px", "belief_angle_rad", "d2_evaluations", "proved", "capped"}  # memory


@dataclass
class Job:
    sequence: str
    strategy: str
    variant: str
    seed: int
    status: str
    folder: Path
    figures: dict[str, float]
    error: str = ""
    notes: list[str] = field(default_factory=list)

    def figure(self, name: str) -> float:
        return self.figures.get(name, math.nan)

    @property
    def metric(self) -> bool:
        """Scale comes from a known target; else an alignment has to fit it."""
        return self.figure("run_map_known") > 0

    @cached_property
    def frames(self) -> pd.DataFrame | None:
        return self._table("frames.csv", ("t_s", "pairs", "rejected"), expected=True)

    @cached_property
    def errors(self) -> pd.DataFrame | None:
        """Error and consistency of every frame; only batches with truth have it."""
        return self._table("errors.csv", ("t_s",), expected=False)

    @cached_property
    def map(self) -> pd.DataFrame | None:
        return self._table("map.csv", ("x_m", "y_m", "z_m"), expected=True)

    @cached_property
    def track(self) -> Track | None:
        """The path over the truth; None without truth."""
        if self.status != "done":
            return None
        try:
            track = track_of(self.folder, with_scale=not self.metric)
        except ValueError as error:
            self._note("trajectory.tum", str(error))
            return None
        return track_from_errors(self.errors) if track is None and self.errors is not None else track

    @property
    def start_s(self) -> float:
        return float(self.frames["t_s"].iloc[0])

    def _table(self, name: str, columns: tuple[str, ...], expected: bool) -> pd.DataFrame | None:
        if self.status != "done":
            return None
        file = self.folder / name
        if not file.exists():
            if expected:
                self._note(name, "no such file")
            return None
        try:
            table = pd.read_csv(file, usecols=lambda column: column not in UNUSED)
        except (ValueError, OSError) as error:
            self._note(name, str(error).splitlines()[0])
            return None
        lacking = [column for column in columns if column not in table]
        if lacking or table.empty:
            self._note(name, f"column '{lacking[0]}' is missing" if lacking else "no rows")
            return None
        return table

    def _note(self, name: str, what: str) -> None:
        self.notes.append(f"{self.sequence}/{self.strategy}/{self.variant}, seed {self.seed}: {name}: {what}")
