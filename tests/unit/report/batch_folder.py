# SPDX-License-Identifier: BSD-3-Clause
"""A small batch's output folder, as mono-slam-batch would leave it."""
import math
import tempfile
from pathlib import Path

import numpy as np
import pandas as pd


class BatchFolder:
    """Runs on a circle; every estimate is the truth, turned, shifted and disturbed."""

    def __init__(self):
        self._temporary = tempfile.TemporaryDirectory()
        self.path = Path(self._temporary.name)
        self.rows = []

    def close(self) -> None:
        self._temporary.cleanup()

    def add(self, strategy: str, seed: int, status: str = "done", sequence: str = "circle", variant: str = "default",
            **figures) -> Path:
        name = f"jobs/{sequence}/{strategy}/{variant}/seed-{seed}-0"
        row = {"sequence": sequence, "strategy": strategy, "variant": variant, "seed": seed, "status": status,
               "error": "ran away" if status == "failed" else "", "folder": name, "run_map_known": 4}
        self.rows.append(row | figures)
        folder = self.path / name
        if status == "done":
            folder.mkdir(parents=True)
            self._write(folder, np.random.default_rng(seed))
        return folder

    def collect(self) -> Path:
        pd.DataFrame(self.rows).to_csv(self.path / "results.csv", index=False)
        return self.path

    def _write(self, folder: Path, rng: np.random.Generator) -> None:
        n = 30
        t = 100 + np.arange(n) / 10
        pairs, rejected = np.full(n, 12), rng.integers(0, 3, n)
        pd.DataFrame({
            "index": range(n), "t_s": t, "pairs": pairs, "rejected": rejected, "nodes": 10 * rejected,
            "leaves": 5 * rejected, "associate_ms": 0.5, "joint_d2": rng.chisquare(2 * (pairs - rejected)),
            "beliefs": 1, "effective_beliefs": 1.0, "belief_distance": 0.0, "ancestor_age_frames": 0,
        }).to_csv(folder / "frames.csv", index=False)
        angle = np.arange(n) / 10
        circle = np.column_stack([np.cos(angle), np.sin(angle), 0.1 * angle])
        turned = circle @ np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]]) + [1, 2, 3]
        write_tum(folder / "groundtruth.tum", t, circle, (0, 0, 0, 1))
        write_tum(folder / "trajectory.tum", t, turned + 0.001 * rng.normal(size=(n, 3)),
                  (0, 0, -math.sqrt(0.5), math.sqrt(0.5)))
        entries = {f"P_{a}_{b}": 1e-4 * (a == b) for a, b in ("xx", "xy", "xz", "yy", "yz", "zz")}
        points = rng.normal(size=(9, 3))
        pd.DataFrame({"x_m": points[:, 0], "y_m": points[:, 1], "z_m": points[:, 2], **entries}).to_csv(
            folder / "map.csv", index=False)


def write_tum(file: Path, t: np.ndarray, positions: np.ndarray, orientation: tuple) -> None:
    file.write_text("".join(f"{time:.7f} {x:.9g} {y:.9g} {z:.9g} {' '.join(map(str, orientation))}\n"
                            for time, (x, y, z) in zip(t, positions)))
