# SPDX-License-Identifier: BSD-3-Clause
"""The experiments of Guerra et al. 2013: tables, figures, verdicts. Called by run.sh, which see."""
import argparse
import concurrent.futures
import os
import subprocess
import sys
import time
from pathlib import Path

import batches
import chapters
import document
import pandas as pd
import problems
import worlds
from plan import (CONFIG, DEFAULTS, FULL, PAIRS, PRINTED, QUICK, ROOT, WHOLE_RUNS, estimate_s,
                  initialization_variants)
from programs import write_text


def parse():
    parser = argparse.ArgumentParser(prog="run.sh", description=__doc__.split(".", 1)[0])
    parser.add_argument("--quick", action="store_true", help="two short sequences of half size")
    parser.add_argument("--worlds", type=Path, help="rendered sequences; incomplete ones are left out")
    parser.add_argument("--output", type=Path, help="a call goes on where an earlier one ended")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="runs at a time")
    parser.add_argument("--document", type=Path, help="write the Markdown to this file as well")
    parser.add_argument("--datasets", type=Path, help="real sequences", default=os.environ.get(
        "MONOSLAM_DATASETS", ROOT.parent / "shared" / "datasets"))
    args = parser.parse_args()
    if args.jobs < 1:
        sys.exit("run.sh: --jobs: must be at least 1")
    if args.worlds and not args.worlds.is_dir():
        sys.exit(f"run.sh: --worlds: {args.worlds}: no such folder")
    args.output = (args.output or ROOT / "build" / f"guerra2013{'-quick' if args.quick else ''}").resolve()
    return args


def tell(text):
    print(text, file=sys.stderr, flush=True)


def claim(output):
    """The output folder, which must be ours or empty."""
    mark = output / "batches"
    if output.exists() and not output.is_dir() or (
            output.is_dir() and any(output.iterdir()) and not mark.is_dir()):
        sys.exit(f"run.sh: --output: {output}: is not empty and not of this experiment")
    mark.mkdir(parents=True, exist_ok=True)


def render(folder, plan):
    """What is missing; frames that are there are kept."""
    script = ROOT / "datasets" / "render.sh"
    if subprocess.run([script, folder, "--world", plan.world], stdout=sys.stderr).returncode:
        sys.exit(f"run.sh: {folder}: the sequences could not be rendered")


def find(args, plan):
    """Rendered sequences that are complete, what the others lack, and the real ones."""
    folder = args.worlds or Path(os.environ.get("MONOSLAM_WORLDS") or ROOT / "build" / (
        "worlds-quick" if args.quick else "worlds"))
    rendered, missing = worlds.rendered(folder, plan.sequences)
    if missing and not args.worlds:
        render(folder, plan)
        rendered, missing = worlds.rendered(folder, plan.sequences)
    for name, lack in missing.items():
        tell(f"left out: {name}: {lack}")
    if not rendered:
        sys.exit(f"run.sh: {folder}: none of its sequences is complete")
    return rendered, missing, worlds.real(Path(args.datasets)) if plan.real else []


def make_rawlogs(sequences, args):
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        made = pool.map(lambda sequence: worlds.make_rawlog(sequence, args.output), sequences)
        return {sequence.name: rawlog for sequence, rawlog in zip(sequences, made)}


def run_batches(args, plan, rendered, real, rawlogs):
    """Rows of each batch by its name; results.csv is all of them."""
    turning = [s for s in rendered if s.kind in ("uturn", "turn")]
    asked = {"nodes": (CONFIG, rendered, WHOLE_RUNS, plan.node_seeds),
             "initialization": (CONFIG, rendered, list(initialization_variants().values()),
                                plan.initialization_seeds)}
    if turning:
        asked["validation"] = (CONFIG, turning, PAIRS[CONFIG.name], plan.validation_seeds)
        asked["defaults"] = (DEFAULTS, turning, PAIRS[DEFAULTS.name], plan.default_seeds)
    if real:
        asked["real"] = (CONFIG, real, WHOLE_RUNS, plan.node_seeds)
    rows = {}
    for name, batch in asked.items():
        started = time.monotonic()
        rows[name] = batches.run(name, args.output, rawlogs, args.jobs, *batch)
        tell(f"{name}: {len(rows[name])} runs, {time.monotonic() - started:.0f} s")
    everything = batches.all_rows(rows.values())
    write_text(args.output / "results.csv", everything.to_csv(index=False))
    failed = everything[everything.status != "done"]
    for row in failed.itertuples():
        tell(f"failed: {row.folder}: {row.error}")
    return rows


def lengths_of(rows, sequences):
    """Frames and seconds of every run with the printed HOHCT."""
    by_name = {s.name: s for s in sequences}
    mine = batches.done(rows)[batches.done(rows).variant == PRINTED.name]
    return pd.DataFrame([{"sequence": row.sequence, "frames": row.frames, "seconds":
                          by_name[row.sequence].times[-1] - by_name[row.sequence].times[0]}
                         for row in mine.itertuples()])


def searches(args, sequences, rows, rawlogs):
    started = time.monotonic()
    found = problems.of_all(args.output, sequences, rawlogs, rows, args.jobs)
    tell(f"problems: {len(found)} solutions, {time.monotonic() - started:.0f} s")
    return {"problems": found, "runs": lengths_of(rows, sequences),
            "frames": batches.all_frames(args.output, rows)}


def what_ran(args, rendered, missing, real, rows):
    command = "apps/experiments/guerra2013/run.sh" + (" --quick" if args.quick else "")
    everything = batches.all_rows(rows.values())
    failed = everything[everything.status != "done"]
    text = (f"By `{command}`: {len(rendered)} rendered sequences of {sum(s.frames for s in rendered)} "
            f"frames, {len(everything)} runs, {len(failed)} of them failed.")
    if missing:
        text += " Not complete in the folder of worlds, and left out: " + ", ".join(missing) + "."
    if real:
        text += " Real sequences: " + ", ".join(s.name for s in real) + "."
    return text


def main():
    args = parse()
    plan = QUICK if args.quick else FULL
    claim(args.output)
    rendered, missing, real = find(args, plan)
    minutes = estimate_s(plan, [*rendered, *real], args.jobs) / 60
    tell(f"{len(rendered)} rendered, {len(real)} real sequences; about {minutes:.1f} minutes")
    rawlogs = make_rawlogs([*rendered, *real], args)
    rows = run_batches(args, plan, rendered, real, rawlogs)
    evidence = searches(args, rendered, rows["nodes"], rawlogs)
    on_real = searches(args, real, rows["real"], rawlogs) if real else None
    sections = chapters.all_of(args.output, rendered, rows, evidence, on_real)
    document.write(args.output, sections, what_ran(args, rendered, missing, real, rows))
    if args.document:
        write_text(args.document, (args.output / "guerra2013.md").read_text())
    tell(f"{args.output}/guerra2013.md")
    report = ROOT / "apps" / "mono-slam-report" / "mono-slam-report"
    sys.exit(subprocess.run([report, args.output]).returncode)


if __name__ == "__main__":
    main()
