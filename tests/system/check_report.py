# SPDX-License-Identifier: BSD-3-Clause
"""usage: check_report.py RESULTS FIRST_SECTION STRATEGY...

report.html is one file that refers to nothing outside itself, has every section, and a picture of
the runs in it; figures stand beside it as SVG and PNG.
"""
import sys
from html.parser import HTMLParser
from pathlib import Path

STANDARD = ["Results over seeds", "Trajectories", "Maps", "Errors over time", "Cost of validation", "Consistency",
            "Rejections", "Diversity of particles", "Example frames", "About these runs"]
REFERRING = {"src", "srcset", "href", "xlink:href", "data", "poster", "action"}
VOID = {"meta", "img", "br", "hr", "link", "input", "wbr", "col"}


class Page(HTMLParser):
    def __init__(self):
        super().__init__()
        self.titles, self.references, self.ids, self.drawings, self.open = [], [], [], 0, []
        self.in_title = False

    def handle_starttag(self, tag, attributes):
        if tag in ("script", "link", "iframe", "object"):
            sys.exit(f"<{tag}> in the report")
        for name, value in attributes:
            if name in REFERRING:
                self.references.append(value)
            if name == "id":
                self.ids.append(value)
        self.drawings += tag in ("svg", "img")
        self.in_title = tag == "h2"
        self.titles += [""] if self.in_title else []
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        self.in_title = False
        if tag not in VOID and (not self.open or self.open.pop() != tag):
            sys.exit(f"</{tag}> closes something else")

    def handle_data(self, data):
        if self.in_title:
            self.titles[-1] += data


def main() -> None:
    results, first, strategies = Path(sys.argv[1]), sys.argv[2], sys.argv[3:]
    text = (results / "report.html").read_text(encoding="utf-8")
    page = Page()
    page.feed(text)
    page.close()
    assert not page.open, f"never closed: {page.open}"
    assert page.titles == [first, *STANDARD], page.titles
    outside = [r for r in page.references if not r.startswith(("#", "data:image/"))]
    assert not outside, f"refers to {outside}"
    for word in ("http://", "https://", "file:", "@import", str(results.resolve())):
        assert word not in text, f"{word} in the report"
    assert len(page.ids) == len(set(page.ids)), "two elements have the same id"
    unknown = {r[1:] for r in page.references if r.startswith("#")} - set(page.ids)
    assert not unknown, f"links to nowhere: {unknown}"
    assert page.drawings >= 8, f"only {page.drawings} figures"
    for strategy in strategies:
        assert f">{strategy}<" in text, f"{strategy} is missing"
    drawn = {file.stem for file in (results / "figures").glob("batch_*.svg")}
    assert drawn and drawn == {file.stem for file in (results / "figures").glob("batch_*.png")}, drawn


if __name__ == "__main__":
    main()
