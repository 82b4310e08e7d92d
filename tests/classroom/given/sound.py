"""Whether a report of hostile input is sound: numbers, no formula, no element that is not ours."""

from __future__ import annotations

import csv
import io
import json
import re
from html.parser import HTMLParser
from typing import Any

from sim.classroom.show.class_csv import items_csv, students_csv
from sim.classroom.show.report_page import report_html

FORMULA = re.compile(r"[\s\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff\"']*[=+@＝＋＠]")
NUMBER = re.compile(r"-?\d")


ELEMENTS = frozenset(
    (
        "p",
        "h2",
        "h3",
        "h4",
        "h5",
        "ul",
        "ol",
        "li",
        "section",
        "figure",
        "div",
        "table",
        "thead",
        "tbody",
        "tr",
        "th",
        "td",
        "bdi",
        "small",
        "span",
        "details",
        "summary",
        "svg",
        "g",
        "path",
        "circle",
        "rect",
        "line",
        "text",
        "title",
    )
)


def sound(report: dict[str, Any]) -> None:
    """JSON without NaN, HTML of ours alone, no cell that a spreadsheet would run."""
    json.dumps(report, allow_nan=False)
    reader = _Elements()
    reader.feed(report_html(report))
    assert reader.found <= ELEMENTS, reader.found - ELEMENTS
    for text in (students_csv(report), items_csv(report)):
        for row in csv.reader(io.StringIO(text.removeprefix("\ufeff"))):
            for cell in row:
                assert cell.startswith("'") or not FORMULA.match(cell), cell
                assert not cell.startswith("-") or NUMBER.match(cell), cell


class _Elements(HTMLParser):
    """The elements of a page; none may have a handler, and no address leads anywhere."""

    def __init__(self) -> None:
        super().__init__()
        self.found: set[str] = set()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.add(tag)
        assert not [name for name, _ in attrs if name.startswith("on") or name in ("href", "src")]
