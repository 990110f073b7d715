# SPDX-License-Identifier: BSD-3-Clause
"""Sections of a report and the page made of them."""
import math
import re
from dataclasses import dataclass, field
from pathlib import Path

import markdown
from jinja2 import Environment, FileSystemLoader, select_autoescape
from markupsafe import Markup

from . import style
from .figures import Figure

TEMPLATE = "report.html.j2"


@dataclass(frozen=True)
class Table:
    head: list[str]
    rows: list[list[str]]  # text, or Markup
    caption: str = ""


@dataclass(frozen=True)
class Fold:
    """A figure that the reader opens and closes, so that long reports stay short."""

    title: str
    figure: Figure
    opened: bool


@dataclass
class Section:
    title: str
    blocks: list[Markup | Table | Figure | Fold] = field(default_factory=list)

    @property
    def anchor(self) -> str:
        return re.sub(r"[^a-z0-9]+", "-", self.title.lower()).strip("-")

    def say(self, text: str) -> None:
        """A paragraph of Markdown."""
        self.blocks.append(markup_of(text))


def markup_of(text: str) -> Markup:
    return Markup(markdown.markdown(text, extensions=["tables", "fenced_code", "sane_lists"]))


def render(title: str, intro: str, facts: str, sections: list[Section]) -> str:
    environment = Environment(loader=FileSystemLoader(Path(__file__).parent), trim_blocks=True,
                              lstrip_blocks=True, autoescape=select_autoescape(default=True))
    environment.tests.update(fold=lambda block: isinstance(block, Fold), table=lambda block: isinstance(block, Table),
                             figure=lambda block: isinstance(block, Figure))
    return environment.get_template(TEMPLATE).render(
        title=title, intro=markup_of(intro), facts=facts, sections=numbered(sections),
        variables=style.variables())


def numbered(sections: list[Section]) -> list[tuple[str, Section]]:
    """With anchors that differ even where titles do not."""
    return [(f"s{number}-{section.anchor}", section) for number, section in enumerate(sections, 1)]


def short(number: float, digits: int = 3) -> str:
    """So many digits, never in powers of ten for what fits a line."""
    if math.isinf(number):
        return "∞"
    if number == 0 or 1e-3 <= abs(number) < 1e5:
        decimals = max(0, digits - 1 - math.floor(math.log10(abs(number)))) if number else 0
        return f"{number:.{decimals}f}" if number % 1 else f"{number:.0f}"
    return f"{number:.{digits - 1}e}"
