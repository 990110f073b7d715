# SPDX-License-Identifier: BSD-3-Clause
"""Which runs are made: batches at full size and in the quick form."""
from dataclasses import dataclass

import worlds
from batches import CONFIGURATIONS, Batch, by_configuration
from methods import CAPPED, MHDA, PLAIN, STRATEGIES, STRATEGY_OF_VARIANT, cap_settings


@dataclass(frozen=True)
class Size:
    """What differs between the experiment and its quick form."""
    lengths: tuple  # frames of the two tables
    moved_frames: int
    seeds: int
    own_seeds: int  # at most, with our defaults, which the paper does not have
    recovery_seeds: int
    capped_seeds: int
    sweep_seeds: int
    cap_s: float  # of MRPT's search
    nodes: int  # of ours without bound: about 2 s as well
    rate_size: tuple
    rate_frames: int
    rate_seeds: int
    real_seeds: int
    sweeps: dict
    probe_frames: int  # 0: no estimate


SWEEPS = {"particles": (1, 2, 4, 8, 16),
          "p_present": (0.5, 0.7, 0.8, 0.9, 0.95, 0.99),
          "p_search": (0.5, 0.8, 0.9, 0.95, 0.99, 0.999),
          "clutter_per_image": (1, 5, 20, 50, 100, 400)}
FULL = Size((200, 600), 200, 20, 5, 6, 3, 3, 2.0, 2_500_000, (480, 320), 200, 2, 2, SWEEPS, 40)
QUICK = Size((20, 40), 40, 1, 1, 1, 1, 1, 0.02, 20_000, (240, 160), 20, 1, 0,
             {"particles": (1, 2), "p_present": (0.7, 0.9), "p_search": (0.9, 0.95),
              "clutter_per_image": (20, 100)}, 0)


def table_batch(name, sequences, size, seeds=None):
    return Batch(name, sequences, list(CONFIGURATIONS), STRATEGIES, {PLAIN: ({}, None)}, seeds or size.seeds)


def capped_batch(name, sequences, size, seeds):
    settings = cap_settings(size.cap_s, size.nodes)
    variants = {variant: (settings[variant], STRATEGY_OF_VARIANT[variant]) for variant in CAPPED}
    return Batch(name, sequences, list(CONFIGURATIONS), list(STRATEGY_OF_VARIANT.values()), variants, seeds)


def sweep_batch(parameter, values, sequences, size):
    """The paper's settings with one of MHDA's parameters changed."""
    variants = {f"{parameter}_{value}": ({f"association.mhda.{parameter}": value}, None) for value in values}
    return Batch(f"sweep-{parameter}", sequences, ["paper"], [MHDA], variants, size.sweep_seeds)


def sequences(folder, moved, output, size):
    """(the two lengths of the office, the office with the displaced object, the office at the rates' size)"""
    office = [worlds.sequence_of(folder, output, frames) for frames in size.lengths]
    disturbed = worlds.sequence_of(moved, output, size.moved_frames)
    for sequence in (office[0], disturbed):
        sequence.settings["output.associations"] = "true"
    small = worlds.sequence_of(worlds.resized(folder, output, size.rate_size, size.rate_frames), output,
                               size.rate_frames)
    small.settings |= {"map.measured_target": 50, "association.max_measured": 50}
    return office, disturbed, small


def batches(office, disturbed, small, size):
    """All batches on the rendered worlds, the longest runs first, so that none of them is left at the end."""
    both = [capped_batch(f"capped-{s.frames}", [s], size, size.capped_seeds) for s in reversed(office)]
    both += [table_batch("table2", office[::-1], size), table_batch("recovery", [disturbed], size, size.recovery_seeds)]
    found = [part for batch in both for part in by_configuration(batch, size.own_seeds)]
    for parameter, values in size.sweeps.items():
        with_moved = [office[0], disturbed] if parameter == "particles" else [office[0]]
        found.append(sweep_batch(parameter, values, with_moved, size))
    rates = [table_batch("rates", [small], size, size.rate_seeds), capped_batch("rates-capped", [small], size, 1)]
    for batch in rates:
        batch.jobs = 1  # a time is told only of a core that nothing of ours shares
    return found + rates
