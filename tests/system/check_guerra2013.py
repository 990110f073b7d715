# SPDX-License-Identifier: BSD-3-Clause
"""check_guerra2013.py RESULTS: tables and figures are complete, and totals add up."""
import csv
import json
import sys
from pathlib import Path

RESULTS = Path(sys.argv[1])
TABLES = """claims table1 table2 table2_work table3 table4 table5 table5_parts pairs along_track by_sequence
    equations growth exponents causes initialization initialization_tests figure5_guerra2013 figure5_default
    tracking_guerra2013 tracking_default""".split()
FIGURES = "figure5 figure5_defaults nodes sizes places times gaps initialization".split()
failures = []


def expect(condition, what):
    if not condition:
        failures.append(what)


def table(name):
    with open(RESULTS / "tables" / f"{name}.csv", newline="") as stream:
        return list(csv.DictReader(stream))


def same(name, value, expected):
    expect(abs(value - expected) < 1e-3 * max(abs(expected), 1), f"{name}: {value}, not {expected}")


def totals():
    """Searches by five tables; nodes by Table 2 and by what the runs themselves counted."""
    searches = int(table("table4")[-1]["searches"])
    one = {row[""]: row for row in table("table1")}
    same("searches of Table 1", float(one["searches"]["all 2 runs"]), searches)
    for name in ("pairs", "along_track"):
        same(f"searches of {name}", sum(int(row["searches"]) for row in table(name)), searches)
    same("searches of Table 4", sum(int(row["searches"]) for row in table("table4")[:-1]), searches)
    same("searches of by_sequence", sum(float(row["searches a run"]) * int(row["runs"])
                                        for row in table("by_sequence")), searches)
    nodes = frames = 0
    with open(RESULTS / "results.csv", newline="") as stream:
        runs = list(csv.DictReader(stream))
    for run in runs:
        if run["variant"] == "hohct_printed" and run["seed"] == "1":
            with open(RESULTS / run["folder"] / "frames.csv", newline="") as stream:
                counted = [int(row["nodes"]) for row in csv.DictReader(stream)]
            nodes, frames = nodes + sum(counted), frames + len(counted)
    same("frames of Table 1", float(one["frames"]["all 2 runs"]), frames)
    same("nodes of Table 2", 2 * float(table("table2")[0]["nodes / run"]), nodes)
    expect(searches > 0, "no searches")
    expect(all(run["status"] == "done" for run in runs), "a run has failed")


def files():
    for name in TABLES:
        file = RESULTS / "tables" / f"{name}.csv"
        expect(file.exists(), f"no table {name}")
        rows = table(name) if file.exists() else []
        expect(rows and all(all(cell for cell in list(row.values())[1:] if cell is not None)
                            or name == "claims" for row in rows), f"{name} has empty cells")
    for name in FIGURES:
        for kind in ("svg", "png"):
            file = RESULTS / "figures" / f"{name}.{kind}"
            expect(file.exists() and file.stat().st_size > 2000, f"no figure {file.name}")
    report = json.loads((RESULTS / "report.json").read_text())
    for section in report["sections"]:
        for key, ending in (("table", ""), ("figure", ".svg")):
            if key in section:
                expect((RESULTS / (section[key] + ending)).exists(), f"no {section[key]}")
    titles = {section["title"] for section in report["sections"]}
    for figure in (6, 7):
        expect(any(title.startswith(f"Figure {figure}") for title in titles), f"no Figure {figure}")
    expect((RESULTS / "report.html").stat().st_size > 100_000, "report.html is too small")


def verdicts():
    known = {"holds", "does not hold", "in part", "not decided"}
    claims = table("claims")
    expect(len(claims) == 20, f"{len(claims)} claims")
    for row in claims:
        expect(row["verdict"] in known and any(c.isdigit() for c in row["numbers"]), row["claim"])


files()
totals()
verdicts()
print("\n".join(failures) or "all there, totals add up")
sys.exit(1 if failures else 0)
