# SPDX-License-Identifier: BSD-3-Clause
"""The association problems of the runs with the printed HOHCT, and what every method does with them.

A run is made again with --dump-frames for the frames in which its full set of pairs was not
compatible: those are what the paper counts as searches. association-bench solves the files.
"""
import concurrent.futures
import filecmp
import os
import shutil
import sys

import pandas as pd
from batches import done, frames_of
from plan import CONFIG, ON_PROBLEMS, PRINTED
from programs import call, program, settings_as_arguments

DEPTH_EVERY = 10  # frames of the rendered laboratory that have depth


def depth_frame(frame):
    """The last one before a frame."""
    return max(frame - 1, 0) // DEPTH_EVERY * DEPTH_EVERY


def frames_to_dump(frames):
    """Of the searches, and the frames with depth before them, where causes are looked for."""
    searches = frames.loc[frames.nodes > 0, "index"]
    return searches, sorted({*searches, *(depth_frame(frame) for frame in searches)})


def dump(output, sequence, rawlog, row):
    """The folder of one run's problems, and its searches."""
    searches, wanted = frames_to_dump(frames_of(output, row))
    folder = output / "problems" / sequence.name / row.folder.rsplit("/", 1)[1]
    if len(searches) and not folder.exists():
        part = folder.with_name(folder.name + ".part")
        shutil.rmtree(part, ignore_errors=True)
        part.parent.mkdir(parents=True, exist_ok=True)
        settings = {"association.strategy": PRINTED.strategy, **sequence.settings,
                    **PRINTED.settings}
        call(program("mono-slam"), CONFIG, rawlog, *settings_as_arguments(settings),
             "--seed", row.seed, "--output", part / "run", "--dump-association", part / "dump",
             "--dump-frames", ",".join(str(frame) for frame in wanted))
        if not filecmp.cmp(part / "run" / "trajectory.tum", output / row.folder / "trajectory.tum",
                           shallow=False):
            sys.exit(f"{row.folder}: a second run gives another trajectory")
        os.replace(part, folder)
    return folder, list(searches)


def solve(folder, searches, method):
    """A row a problem."""
    csv = folder / f"{method.name}.csv"
    if not csv.exists():
        part = folder / f"{method.name}.csv.part"
        files = [folder / "dump" / f"association_{frame:06d}.json" for frame in searches]
        call(program("association-bench"), "--config", CONFIG, "--strategies", method.strategy,
             *settings_as_arguments(method.settings), "--csv", part, "--force", *files)
        os.replace(part, csv)
    return pd.read_csv(csv, dtype={"rejected_ids": str}, keep_default_na=False,
                       na_values=["nan"]).assign(method=method.name)


def check(row, frames, solved):
    """The printed HOHCT must find on the files what it found in the run: totals add up.

    Not so the rejected pairs: a frame whose few matches may be chance drops them all afterwards.
    """
    there = solved[solved.method == PRINTED.name]
    here = frames[frames.nodes > 0]
    for column in ("nodes", "leaves", "pairs"):
        if there[column].sum() != here[column].sum():
            sys.exit(f"{row.folder}: {column} of the files: {there[column].sum()}, of the run: "
                     f"{here[column].sum()}")


def of_run(output, sequence, rawlog, row):
    folder, searches = dump(output, sequence, rawlog, row)
    if not searches:
        return pd.DataFrame()
    solved = pd.concat([solve(folder, searches, method) for method in ON_PROBLEMS])
    check(row, frames_of(output, row), solved)
    return solved.assign(sequence=sequence.name, kind=sequence.kind, seed=row.seed,
                         track=solved.frame / (sequence.frames - 1), folder=str(folder))


def of_all(output, sequences, rawlogs, rows, jobs):
    """Every search of all runs by every method; n is pairs, r is rejected by the printed HOHCT."""
    by_name = {sequence.name: sequence for sequence in sequences}
    runs = done(rows)[done(rows).variant == PRINTED.name]
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        parts = list(pool.map(lambda row: of_run(output, by_name[row.sequence],
                                                 rawlogs[row.sequence], row), runs.itertuples()))
    solved = pd.concat(parts, ignore_index=True) if any(len(p) for p in parts) else None
    if solved is None:
        sys.exit("no frame of any sequence needed a search: there is nothing to count")
    key = ["sequence", "seed", "frame"]
    printed = solved[solved.method == PRINTED.name].set_index(key)
    size = printed[["pairs", "rejected"]].rename(columns={"pairs": "n", "rejected": "r"})
    return solved.join(size, on=key)
