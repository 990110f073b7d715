# SPDX-License-Identifier: BSD-3-Clause
"""Figures of a report: written as SVG and PNG, and put into the page as SVG that follows its colours."""
import base64
import os
import re
from dataclasses import dataclass
from pathlib import Path

import matplotlib.pyplot as plt

from . import style

OURS = re.compile(r"#[0-9a-f]{6}\b")
LONG = re.compile(r"(\d\.\d\d)\d+")  # a hundredth of a point cannot be seen


@dataclass(frozen=True)
class Figure:
    markup: str  # <svg> or <img>, with all its data
    caption: str


class FigureFolder:
    """RESULTS/figures. The report's own figures begin with batch_; what else is there is left alone."""

    def __init__(self, results: Path):
        self.folder = results / "figures"

    def save(self, figure: plt.Figure, name: str, caption: str) -> Figure:
        for kind, metadata in (("svg", {"Date": None, "Creator": None}), ("png", {"Software": None})):
            file = self.path(f"{name}.{kind}")
            part = file.with_name(file.name + ".part")
            figure.savefig(part, format=kind, metadata=metadata, transparent=kind == "svg")
            os.replace(part, file)
            figure.set_layout_engine("none")  # laid out once is enough
        plt.close(figure)
        drawing = self.path(f"{name}.svg")
        return Figure(inline(drawing.read_text(encoding="utf-8"), drawing.stem, caption), caption)

    def path(self, name: str) -> Path:
        self.folder.mkdir(exist_ok=True)
        return self.folder / ("batch_" + re.sub(r"[^A-Za-z0-9_.+-]", "_", name))


def inline(svg: str, prefix: str, label: str) -> str:
    """The <svg> element alone: own identifiers, colours as CSS variables, as wide as the page allows."""
    element = svg[svg.index("<svg"):]
    element = re.sub(r"<metadata>.*?</metadata>", "", element, flags=re.S)
    element = re.sub(r'\sxmlns(:\w+)?="[^"]*"', "", element)
    element = re.sub(r'\bid="([^"]+)"', rf'id="{prefix}-\1"', element)
    element = re.sub(r'href="#([^"]+)"', rf'href="#{prefix}-\1"', element)
    element = re.sub(r'\bd="[^"]*"', lambda path: LONG.sub(r"\1", path[0]), element)
    element = element.replace("url(#", f"url(#{prefix}-")
    named = {colour: f"var(--{name})" for name, (colour, _, _) in style.variables().items()}
    element = OURS.sub(lambda found: named.get(found[0], found[0]), element)
    head, rest = element.split(">", 1)
    head = re.sub(r'\s(width|height|version)="[^"]*"', "", head)
    return f'{head} role="img" aria-label="{escape(label)}">{rest}'


def escape(text: str) -> str:
    return text.replace("&", "&amp;").replace('"', "&quot;").replace("<", "&lt;")


def picture(file: Path, label: str) -> str:
    """A picture as a data URI. An SVG in other colours than ours stays as it is, on white."""
    kind = {".png": "png", ".jpg": "jpeg", ".svg": "svg+xml"}[file.suffix]
    data = base64.b64encode(file.read_bytes()).decode()
    return f'<img class="paper" alt="{escape(label)}" src="data:image/{kind};base64,{data}">'


def drawn_in_our_look(svg: str) -> bool:
    return style.INK in svg
