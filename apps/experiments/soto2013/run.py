# SPDX-License-Identifier: BSD-3-Clause
"""Table 2 and Fig. 1 of Soto-Alvarez and Honkamaa (2013), with sweeps and frame rates. Called by run.sh."""
import argparse
import os
import subprocess
import sys
import time
from pathlib import Path

import pandas as pd

import batches
import chapters
import claims
import estimate
import plan
import quantities
import real
import sweeps
import worlds
from document import Document
from methods import MHDA
from moved_object import BEFORE, moved_frames


def arguments():
    parser = argparse.ArgumentParser(prog="run.sh", description=__doc__)
    parser.add_argument("--quick", action="store_true", help="40 frames at half size, few seeds: a test of the command")
    parser.add_argument("--worlds", type=Path, help="folder of the rendered worlds, which must be complete")
    parser.add_argument("--output", type=Path, help="results; a call goes on where an earlier one ended")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="runs at a time")
    args = parser.parse_args()
    if args.jobs < 1:
        parser.error("--jobs must be at least 1")
    kind = "-quick" if args.quick else ""
    args.output = (args.output or batches.ROOT / "build" / f"soto2013{kind}").resolve()
    args.worlds = args.worlds.resolve() if args.worlds else None
    return args


def find_worlds(args, size):
    """Folders of the office and of the office with the displaced object."""
    default = batches.ROOT / "build" / ("worlds-quick" if args.quick else "worlds")
    folder = args.worlds or Path(os.environ.get("MONOSLAM_WORLDS", default)).resolve()
    needed = {"office": max(size.lengths), "office_moved": size.moved_frames}
    missing = [name for name, frames in needed.items() if not worlds.is_complete(folder / name, frames)]
    if missing and args.worlds:
        sys.exit(f"soto2013: {folder}: not complete: {', '.join(missing)}")
    if missing:
        worlds.render(folder, list(needed), args.quick)
    if moved_frames(folder / "office_moved")[2] + BEFORE > size.moved_frames:
        sys.exit(f"soto2013: {folder / 'office_moved'}: its object moves too late for {size.moved_frames} frames")
    return folder / "office", folder / "office_moved"


def announce(wanted, office, size, args):
    count = sum(batch.runs for batch in wanted)
    print(f"{count} runs in {len(wanted)} batches, {args.jobs} at a time", flush=True)
    if size.probe_frames:
        cost = estimate.measure(office[0], size, args.output, args.jobs)
        minutes = estimate.seconds(*cost, wanted, args.jobs) / 60
        print(f"estimate: {minutes:.0f} min on free cores, by {size.probe_frames} frames of every method", flush=True)


def measured_runs(wanted, args):
    rows = pd.concat([batches.run(batch, args.output, args.jobs) for batch in wanted], ignore_index=True)
    shown = rows[rows.batch.isin(["table2", "recovery", "real"]) | rows.batch.str.startswith("capped")]
    batches.write_aside(args.output / "results.csv", in_names_of_jobs(shown).to_csv(index=False))
    runs = quantities.measure(rows, args.output, real.ALIGNMENTS, args.jobs)
    batches.write_aside(args.output / "runs.csv", runs.to_csv(index=False))
    return runs


def in_names_of_jobs(rows):
    """results.csv as a batch writes it: what mono-slam-report reads. All runs are in runs.csv."""
    rows = rows.assign(sequence=rows.sequence + "." + rows.configuration)
    return rows.drop(columns=["batch", "configuration"]).drop_duplicates("folder")


def report(runs, size, sequences, folders, output):
    office, disturbed, _ = sequences
    document = Document(output)
    cells = chapters.cells_of(runs, office)
    caps = f"after {size.cap_s:g} s of CPU time (MRPT's) or {size.nodes} nodes (ours without bound)"
    document.add("", "")  # the verdicts, which need everything else
    chapters.write_table2(document, cells, caps)
    judged = chapters.write_recovery(document, runs, cells, disturbed, folders[::-1])
    chapters.draw_recovery(document, runs, cells, disturbed, folders[::-1])
    pairs = chapters.write_planes(document, cells, folders[0])
    chapters.write_sweeps(document, runs, size)
    rates = chapters.write_rates(document, runs, size)
    chapters.write_real(document, runs)
    found = chapters.verdicts(cells, judged["paper"], pairs, sweeps.points(runs, "particles"), rates)
    document.add("Does it hold?", "Decided by the numbers below, with the paper's settings and its number of frames "
                 f"unless something else is said.\n\n{claims.reasons(found)}", claims.table(found), "claims")
    document.sections[0] = document.sections.pop()
    failed = int((runs.status == "failed").sum())
    document.write(f"This report is of {len(runs)} runs, {failed} of which failed; they took "
                   f"{runs.time_wall_s.sum() / 3600:.1f} hours of one core.")


def main():
    args = arguments()
    size = plan.QUICK if args.quick else plan.FULL
    start = time.monotonic()
    folders = find_worlds(args, size)
    batches.prepare(args.output)
    sequences = plan.sequences(*folders, args.output, size)
    wanted = plan.batches(*sequences, size)
    datasets = real.folder() if size.real_seeds else None
    if datasets:
        wanted += real.batches(datasets, args.output, size)
    announce(wanted, sequences[0], size, args)
    runs = measured_runs(wanted, args)
    report(runs, size, sequences, folders, args.output)
    subprocess.run([batches.ROOT / "apps" / "mono-slam-report" / "mono-slam-report", args.output,
                    "--reference", MHDA, *(["--cells", "1", "--paths", "1"] if args.quick else [])], check=True)
    print(f"{len(runs)} runs, {(time.monotonic() - start) / 60:.1f} min")


if __name__ == "__main__":
    main()
