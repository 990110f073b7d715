# SPDX-License-Identifier: BSD-3-Clause
"""Sections of a report and the page made of them."""
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


@dataclass
class Section:
    title: str
    blocks: list[Markup | Table | Figure] = field(default_factory=list)

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
    environment.tests.update(table=lambda block: isinstance(block, Table),
                             figure=lambda block: isinstance(block, Figure))
    return environment.get_template(TEMPLATE).render(
        title=title, intro=markup_of(intro), facts=facts, sections=numbered(sections),
        variables=style.variables())


def numbered(sections: list[Section]) -> list[tuple[str, Section]]:
    """With anchors that differ even where titles do not."""
    return [(f"s{number}-{section.anchor}", section) for number, section in enumerate(sections, 1)]
