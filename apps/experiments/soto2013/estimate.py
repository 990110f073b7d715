# SPDX-License-Identifier: BSD-3-Clause
"""What all runs will cost, by the first frames of every method: CPU seconds, which a busy machine does not change."""
import resource

import pandas as pd

import batches
import plan
from methods import PLAIN
from worlds import Sequence


def spent_s():
    """CPU time of all programs that have been run."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def probes(office, size):
    start = Sequence("probe", office.rawlog, office.truth, dict(office.settings), None, size.probe_frames)
    return [plan.table_batch("probe", [start], size, 1), plan.capped_batch("probe-capped", [start], size, 1)]


def measure(office, size, output, jobs):
    """{(strategy, variant, configuration): seconds a frame}, and the seconds of a run beside its frames; kept in
    a file, as a finished probe costs nothing when it is called again."""
    file = output / "batches" / "cost.csv"
    if not file.is_file():
        before = spent_s()
        rows = pd.concat([batches.run(batch, output, jobs) for batch in probes(office, size)])
        spent = spent_s() - before
        frames = [pd.read_csv(output / folder / "frames.csv") for folder in rows.folder]
        seconds = [(f.total_ms + f.decode_ms).sum() / 1e3 for f in frames]
        rows = rows[["strategy", "variant", "configuration"]].assign(
            frame_s=[s / size.probe_frames for s in seconds], start_s=(spent - sum(seconds)) / len(rows))
        batches.write_aside(file, rows.to_csv(index=False))
    rows = pd.read_csv(file)
    cost = {(r.strategy, r.variant, r.configuration): r.frame_s for r in rows.itertuples()}
    return cost, rows.start_s.iloc[0]


def seconds(cost, start_s, wanted, jobs):
    """Of the clock, on cores that nothing else uses."""
    total = 0.0
    for batch in wanted:
        for strategy, variant, sequence, configuration in batch.cells():
            frame_s = cost.get((strategy, variant, configuration), cost[strategy, PLAIN, configuration])
            particles = batch.variants[variant][0].get("association.mhda.particles", 2)
            run_s = start_s + frame_s * max(particles / 2, 1) * (sequence.frames or sequence.length)
            total += run_s * batch.seeds / (batch.jobs or jobs)
    return total
