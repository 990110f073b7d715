# SPDX-License-Identifier: BSD-3-Clause
"""Runs by mono-slam-batch: one ini a question, one folder of jobs for all of them."""
import subprocess
import sys

import pandas as pd
from programs import program, write_text


def ini_of(output, config, sequences, rawlogs, variants, seeds):
    strategies = list(dict.fromkeys(variant.strategy for variant in variants))
    lines = ["[batch]", f"output = {output}", f"strategies = {' '.join(strategies)}",
             f"seeds = {seeds}", f"sequences = {' '.join(s.name for s in sequences)}",
             f"variants = {' '.join(v.name for v in variants)}"]
    for sequence in sequences:
        lines += ["", f"[sequence.{sequence.name}]", f"rawlog = {rawlogs[sequence.name]}",
                  f"config = {config}"]
        lines += [f"truth = {sequence.truth}"] if sequence.truth else ["out_and_back = true"]
        if sequence.marks:  # rendered: landmark errors as well
            lines.append(f"depth = {sequence.folder / 'depth'}")
        lines += [f"{key} = {value}" for key, value in sequence.settings.items()]
    for variant in variants:
        lines += ["", f"[variant.{variant.name}]", f"strategies = {variant.strategy}"]
        lines += [f"{key} = {value}" for key, value in variant.settings.items()]
    return "\n".join(lines) + "\n"


def run(name, output, rawlogs, jobs, config, sequences, variants, seeds):
    """The rows of results.csv of one batch; runs that have ended are not made again."""
    ini = output / "batches" / f"{name}.ini"
    write_text(ini, ini_of(output, config, sequences, rawlogs, variants, seeds))
    results = output / "results.csv"
    results.unlink(missing_ok=True)  # of another batch: must not be taken for this one's
    command = [program("mono-slam-batch"), ini, "--jobs", str(jobs), "--force"]
    subprocess.run([str(word) for word in command], stdout=sys.stderr)
    if not results.exists():
        sys.exit(f"mono-slam-batch: {ini}: has written no results")
    rows = pd.read_csv(results, low_memory=False)
    if (rows.status == "pending").any():
        sys.exit(f"mono-slam-batch: {ini}: runs are missing; call again to go on")
    return rows


def all_rows(batches):
    """Of several batches, a run that belongs to two of them once; what mono-slam-report reads."""
    return pd.concat(batches).drop_duplicates("folder").reset_index(drop=True)


def done(rows):
    return rows[rows.status == "done"]


def frames_of(output, row):
    """frames.csv of one run."""
    return pd.read_csv(output / row.folder / "frames.csv")


def all_frames(output, rows):
    """frames.csv of many runs, with the run's sequence, variant, seed."""
    return pd.concat([frames_of(output, row).assign(sequence=row.sequence, variant=row.variant,
                                                    seed=row.seed)
                      for row in done(rows).itertuples()], ignore_index=True)
