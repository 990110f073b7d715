# SPDX-License-Identifier: BSD-3-Clause
"""RESULTS/report.json: title, introduction and sections that an experiment puts before the standard ones."""
import csv
import json
from dataclasses import dataclass, field
from pathlib import Path

from .errors import ReportError
from .figures import Figure, drawn_in_our_look, inline, picture
from .page import Section, Table

KEYS = {"title", "intro", "sections"}
SECTION_KEYS = {"title", "text", "table", "figure", "caption"}


@dataclass
class Experiment:
    title: str = ""
    intro: str = ""
    sections: list[Section] = field(default_factory=list)


def read_experiment(results: Path) -> Experiment | None:
    file = results / "report.json"
    if not file.exists():
        return None
    try:
        content = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ReportError(f"{file}: {error}") from None
    check(file, "the file", content, KEYS)
    sections = content.get("sections", [])
    if not isinstance(sections, list):
        raise ReportError(f"{file}: sections: must be a list")
    return Experiment(content.get("title", ""), content.get("intro", ""),
                      [section_of(file, f"sections[{i}]", entry) for i, entry in enumerate(sections)])


def check(file: Path, where: str, content, known: set[str]) -> None:
    if not isinstance(content, dict):
        raise ReportError(f"{file}: {where}: must be an object")
    for key, value in content.items():
        if key not in known:
            raise ReportError(f"{file}: {where}: unknown key '{key}'; known are {', '.join(sorted(known))}")
        if key != "sections" and not isinstance(value, str):
            raise ReportError(f"{file}: {where}: {key}: must be a text")


def section_of(file: Path, where: str, entry) -> Section:
    check(file, where, entry, SECTION_KEYS)
    if not entry.get("title"):
        raise ReportError(f"{file}: {where}: title is missing")
    out = Section(entry["title"])
    out.say(entry.get("text", ""))
    if "table" in entry:
        out.blocks.append(table_of(existing(file, f"{where}.table", entry["table"])))
    if "figure" in entry:
        drawing = existing(file, f"{where}.figure", entry["figure"] + ".svg")
        out.blocks.append(figure_of(drawing, entry.get("caption", entry["title"])))
    return out


def existing(file: Path, where: str, name: str) -> Path:
    path = file.parent / name
    if not path.is_file():
        raise ReportError(f"{file}: {where}: {name}: no such file")
    return path


def table_of(file: Path) -> Table:
    with file.open(newline="", encoding="utf-8") as stream:
        rows = list(csv.reader(stream))
    if not rows:
        raise ReportError(f"{file}: an empty table")
    return Table(rows[0], rows[1:])


def figure_of(drawing: Path, caption: str) -> Figure:
    svg = drawing.read_text(encoding="utf-8")
    markup = inline(svg, drawing.stem, caption) if drawn_in_our_look(svg) else picture(drawing, caption)
    return Figure(markup, caption)
