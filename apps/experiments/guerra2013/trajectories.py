# SPDX-License-Identifier: BSD-3-Clause
"""Figure 5 in numbers: with validation and without, over the seeds."""
import math

import pandas as pd
import tracks
from batches import done
from cells import Table
from monoslam_report.seeds import sign_test, summary
from plan import PAIRS

FIGURES = ("straight, length [m]", "turn, opening [deg]", "closing gap [m]")


def measure(output, sequences, rows):
    """A row a run and figure: estimate, truth, error; a run without the poses has error infinity."""
    by_name = {sequence.name: sequence for sequence in sequences}
    found = []
    for row in rows.itertuples():
        sequence = by_name[row.sequence]
        values = tracks.figures(sequence, output / row.folder) if row.status == "done" else {}
        for name in FIGURES:
            if name.split(",")[0] in sequence.marks.get("segments", {}) or name == FIGURES[2]:
                estimate, truth = values.get(name, (math.nan, math.nan))
                error = abs(estimate - truth) if name in values else math.inf
                found.append({"sequence": row.sequence, "kind": sequence.kind, "seed": row.seed,
                              "variant": row.variant, "figure": name, "estimate": estimate,
                              "truth": truth, "error": error})
    return pd.DataFrame(found)


def spread(values):
    s = summary(values)
    return f"{s.median:.3f} [{s.quartiles[0]:.3f}, {s.quartiles[1]:.3f}] {s.worst:.3f}"


def pair(measured, variants, figure, name=None):
    """Errors with validation and without, the same runs in both."""
    mine = measured[measured.figure == figure]
    mine = mine if name is None else mine[mine.sequence == name]
    table = mine.pivot(index=["sequence", "seed"], columns="variant", values="error")
    return [list(table[variant.name]) for variant in variants]


def compared(measured, config):
    """Table: a row a sequence and figure."""
    rows = []
    variants = PAIRS[config]
    for (name, figure), mine in measured.groupby(["sequence", "figure"], sort=False):
        cells = {"sequence": name, "figure": figure, "truth": mine.truth.median()}
        for variant, title in zip(variants, ("HOHCT", "none")):
            runs = mine[mine.variant == variant.name]
            cells[f"{title}: median [quartiles] worst"] = spread(runs.estimate)
            cells[f"{title}: median error"] = summary(runs.error).median
        test = sign_test(*pair(measured, variants, figure, name))
        rows.append({**cells, "HOHCT better": test.wins, "worse": test.losses, "p": test.p})
    return Table(f"figure5_{config.split('.')[0]}", f"Figure 5 in numbers, config/{config}", rows)


def tracking(rows, config):
    """How the runs ended: failed ones, lost frames, error."""
    table = []
    for name, mine in rows.groupby("sequence", sort=False):
        cells = {"sequence": name}
        errors = {}
        for variant, title in zip(PAIRS[config], ("HOHCT", "none")):
            runs = mine[mine.variant == variant.name].set_index("seed")
            errors[title] = runs.SE3_ate_rmse_mm.where(runs.status == "done", math.inf)
            cells[f"{title}: runs"] = len(runs)
            cells[f"{title}: runs with lost frames"] = int((done(runs).frames_lost > 0).sum()
                                                          + (runs.status != "done").sum())
            cells[f"{title}: ATE median [mm]"] = summary(errors[title]).median
            cells[f"{title}: ATE worst [mm]"] = summary(errors[title]).worst
        both = pd.DataFrame(errors)
        test = sign_test(list(both["HOHCT"]), list(both["none"]))
        table.append({**cells, "HOHCT better": test.wins, "worse": test.losses, "p": test.p})
    return Table(f"tracking_{config.split('.')[0]}",
                 f"Trajectory error with validation and without, config/{config}", table)
