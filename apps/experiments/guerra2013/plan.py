# SPDX-License-Identifier: BSD-3-Clause
"""What is run: sequences, methods, variants of the configuration, seeds."""
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
CONFIG = ROOT / "config" / "guerra2013.ini"
KINDS = ("uturn", "turn", "rails", "corridor")
DEFAULTS = ROOT / "config" / "default.ini"
FEATURES = (12, 25, 50)
NODE_CAP = 10_000_000  # of JCBB: about a second; searches that reach it are counted


@dataclass(frozen=True)
class Variant:
    """One way to run mono-slam: a strategy and what differs from the configuration."""

    name: str
    title: str
    strategy: str
    settings: dict = field(default_factory=dict)


PRINTED = Variant("hohct_printed", "HOHCT, printed", "hohct",
                  {"association.hohct.search": "printed"})
UNBOUNDED = Variant("jcbb_unbounded", "JCBB, no bound", "jcbb",
                    {"association.jcbb.bound": "false", "association.jcbb.node_cap": NODE_CAP})
TREE = Variant("hohct_bb", "HOHCT, branch and bound", "hohct",
               {"association.hohct.search": "branch_and_bound"})
BOUNDED = Variant("jcbb_bounded", "JCBB, bound", "jcbb",
                  {"association.jcbb.node_cap": NODE_CAP})
MRPT = Variant("jcbb_mrpt", "MRPT's JCBB, 1 candidate", "jcbb_mrpt")
MRPT_SEVERAL = Variant("jcbb_mrpt_3", "MRPT's JCBB, 3 candidates, 50 ms", "jcbb_mrpt",
                       {"association.jcbb_mrpt.max_candidates": 3,
                        "association.jcbb_mrpt.time_cap_s": 0.05})
NONE = Variant("none", "no validation", "none")
# Of the defaults, which follow more landmarks and do not lose track so easily.
DEFAULT = Variant("default_hohct", "HOHCT", "hohct")
DEFAULT_NONE = Variant("default_none", "no validation", "none")
PAIRS = {"guerra2013.ini": (PRINTED, NONE), "default.ini": (DEFAULT, DEFAULT_NONE)}

WHOLE_RUNS = (PRINTED, UNBOUNDED, TREE, BOUNDED, MRPT)  # Table 5
ON_PROBLEMS = (*WHOLE_RUNS, MRPT_SEVERAL)  # Table 2: what each does with the same problems


def initialization_variants():
    """Delayed and undelayed; the branch and bound, because 50 pairs are too many to enumerate."""
    return {(method, features): Variant(
        f"{method}_{features}", f"{method}, {features} features", "hohct",
        {**TREE.settings, "initialization.method": method, "map.measured_target": features})
        for method in ("delayed", "undelayed") for features in FEATURES}


@dataclass(frozen=True)
class Plan:
    """Full size or quick."""

    world: str  # of datasets/render.sh
    sequences: tuple
    node_seeds: str
    validation_seeds: str
    default_seeds: str
    initialization_seeds: str
    real: bool


FULL = Plan("lab", tuple(f"lab_{kind}_{i}" for i in range(1, 6) for kind in KINDS),
            "1-3", "1-20", "1-5", "1-3", True)
QUICK = Plan("quick", ("lab_uturn_1", "lab_turn_1"), "1", "1-2", "1", "1", False)


def count(seeds):
    """Of seeds as mono-slam-batch writes them, one range."""
    first, _, last = seeds.partition("-")
    return int(last or first) - int(first) + 1


# Milliseconds a frame, with decoding and writing, and seconds a run beside its frames: CPU time of runs of
# 424x240 on the machine that this was written on. For the estimate only.
FRAME_MS = {12: 2.0, 25: 3.0, 50: 6.5}
DEFAULT_MS = 8.0
UNBOUNDED_S = 6  # a run of 600 frames more, for the searches of JCBB without its bound
RUN_S = 0.3


def estimate_s(plan, sequences, jobs):
    """Of the runs to come, none of which has ended."""
    def runs(frame_ms, frames, how_many, variants):
        return variants * (frames * frame_ms / 1000 + how_many * RUN_S)
    frames = sum(s.frames for s in sequences)
    turning = [s for s in sequences if s.marks and s.kind in ("uturn", "turn")]
    in_turns = sum(s.frames for s in turning)
    total = count(plan.node_seeds) * (
        runs(FRAME_MS[25], frames, len(sequences), len(WHOLE_RUNS) + 1) +
        2 * UNBOUNDED_S * frames / 600)  # in the run and on its problems
    total += count(plan.validation_seeds) * runs(FRAME_MS[25], in_turns, len(turning), 2)
    total += count(plan.default_seeds) * runs(DEFAULT_MS, in_turns, len(turning), 2)
    for features in FEATURES:
        total += count(plan.initialization_seeds) * runs(FRAME_MS[features], frames,
                                                         len(sequences), 2)
    return total / jobs
