# SPDX-License-Identifier: BSD-3-Clause
"""Delayed against undelayed initialisation at 12, 25 and 50 features."""
import math

from batches import done
from cells import Table
from monoslam_report.seeds import sign_test, summary
from plan import FEATURES, initialization_variants
from times import tracked


def errors(rows, variant):
    """ATE of every run, infinity where it failed."""
    mine = rows[rows.variant == variant.name].set_index(["sequence", "seed"])
    return mine.SE3_ate_rmse_mm.where(mine.status == "done", math.inf).sort_index()


def cells(rows, frames, variant):
    runs = done(rows[rows.variant == variant.name])
    mine = tracked(frames[frames.variant == variant.name])
    ate = summary(errors(rows, variant))
    return {"runs": ate.n, "ATE median [mm]": ate.median,
            "quartiles": f"{ate.quartiles[0]:.1f} to {ate.quartiles[1]:.1f}",
            "worst": ate.worst, "runs with lost frames": int((runs.frames_lost > 0).sum()),
            "landmark error, median [mm]": 1000 * runs.SE3_landmark_median_m.median(),
            "mean ms": mine.total_ms.mean(), "std ms": mine.total_ms.std(ddof=0),
            "landmarks at the end": runs.run_map_landmarks.mean(),
            "added a run": runs.run_totals_added.mean(), "pairs a frame": mine.pairs.mean(),
            "rejected, % of the pairs": 100 * mine.rejected.sum() / mine.pairs.sum(),
            "searches, % of the frames": 100 * (mine.nodes > 0).mean()}


def compared(rows, frames):
    variants = initialization_variants()
    table = [{"initialisation": method, "features": str(features),
              **cells(rows, frames, variant)} for (method, features), variant in variants.items()]
    return Table("initialization", "Delayed and undelayed initialisation", table)


def tests(rows):
    """Paired by sequence and seed: ATE of the delayed against the undelayed."""
    variants = initialization_variants()
    table = []
    for mine in FEATURES:
        for other in FEATURES:
            test = sign_test(list(errors(rows, variants["delayed", mine])),
                             list(errors(rows, variants["undelayed", other])))
            table.append({"delayed, features": str(mine), "undelayed, features": str(other),
                          "delayed better": test.wins, "worse": test.losses, "equal": test.ties,
                          "p": test.p})
    return Table("initialization_tests", "Delayed against undelayed, paired", table)
