#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""apps/experiments/soto2013 --quick: every table and figure exists, is complete, and is in the report.

    tests/system/soto2013.py PROGRAMS      77: the report's Python packages or povray are missing
"""
import csv
import html
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
METHODS, UNCAPPED = 13, 11  # rows of a table with MRPT's and the unbounded JCBB, and without
ROWS = {"table2": METHODS, "spread": METHODS, "rates": METHODS, "recovery": UNCAPPED, "depth_planes": UNCAPPED}
TABLES, FIGURES, CLAIMS = 15, 7, 11
RUNS = 2 * 2 * METHODS + 2 * UNCAPPED + 2 * METHODS + 2 * 2 + 3 * 2  # tables, recovery, rates, P, other sweeps
VERDICTS = {"holds", "holds in part", "does not hold", "not decided"}


def skip(why):
    print(f"skipped: {why}")
    sys.exit(77)


def rows_of(path):
    with open(path, newline="") as stream:
        return list(csv.DictReader(stream))


def check(condition, message):
    if not condition:
        sys.exit(f"failed: {message}")


def check_table(path):
    rows = rows_of(path)
    check(rows and all(cell for row in rows for cell in row.values()), f"{path}: empty, or an empty cell")
    kind = next((kind for kind in ROWS if path.stem.startswith(kind)), None)
    check(kind is None or len(rows) == ROWS[kind], f"{path}: {len(rows)} rows instead of {ROWS.get(kind)}")


def check_report(output):
    sections = json.loads((output / "report.json").read_text())["sections"]
    tables = {output / section["table"] for section in sections if "table" in section}
    figures = {output / section["figure"] for section in sections if "figure" in section}
    check(len(tables) == TABLES, f"{len(tables)} tables instead of {TABLES}")
    check(len(figures) == FIGURES, f"{len(figures)} figures instead of {FIGURES}")
    for table in tables:
        check_table(table)
    for figure in figures:
        for kind in (".svg", ".png"):
            check(Path(f"{figure}{kind}").stat().st_size > 1000, f"{figure}{kind}: is next to empty")
    page, document = (output / name for name in ("report.html", "soto2013.md"))
    for section in sections:
        check(section["title"] in html.unescape(page.read_text()), f"{page}: section {section['title']} is missing")
        check(f"## {section['title']}\n" in document.read_text(), f"{document}: {section['title']} is missing")


def check_runs(output):
    runs = rows_of(output / "runs.csv")
    check(len(runs) == RUNS, f"runs.csv: {len(runs)} runs instead of {RUNS}")
    check(all(run["status"] == "done" for run in runs), "runs.csv: not all runs are done")
    check(all(0 < float(run["position_m"]) < 1 and float(run["frame_ms"]) > 0 for run in runs), "runs.csv: no error or time")
    check(all(float(run["landmark_mean_m"]) > 0 for run in runs if "x" not in run["sequence"]),
          "runs.csv: no landmark errors")
    claims = rows_of(output / "tables" / "claims.csv")
    check(len(claims) == CLAIMS and all(claim["verdict"] in VERDICTS for claim in claims), "claims.csv: a verdict is missing")


def main():
    venv = Path(os.environ.get("MONOSLAM_REPORT_VENV", ROOT / "build" / "venv-report"))
    if not (venv / "installed.txt").exists():
        skip(f"no {venv}")
    worlds = ROOT / "build" / "worlds-quick"
    if not shutil.which("povray") and not (worlds / "office_moved" / "marks.json").exists():
        skip("povray is not installed")
    with tempfile.TemporaryDirectory() as work:
        output = Path(work) / "two words"
        subprocess.run([ROOT / "apps" / "experiments" / "soto2013" / "run.sh", "--quick", "--output", output],
                       env={**os.environ, "MONOSLAM_PROGRAMS": sys.argv[1], "MONOSLAM_WORLDS": str(worlds)}, check=True)
        check_report(output)
        check_runs(output)


if __name__ == "__main__":
    main()
