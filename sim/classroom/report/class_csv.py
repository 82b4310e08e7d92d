"""The answers and marks of a class as a table for a spreadsheet: one line for each student."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sim.lesson.csv_text import csv_text

STUDENT_COLUMNS = ("lesson", "form", "group", "student", "marks", "of", "open", "to read", "file")
ITEM_COLUMNS = (
    "lesson", "form", "item", "answered by", "right", "partly", "wrong", "open", "to read",
    "difficulty", "discrimination", "point-biserial", "chosen",
)  # fmt: skip


def students_csv(report: Mapping[str, Any]) -> str:
    """Marks by student and form."""
    rows = [
        [
            lesson["lesson"], form["form"], row["group"], row["student"], row["total"], form["of"],
            " ".join(row["open"]), " ".join(row["waiting"]), row["file"],
        ]
        for lesson in report["lessons"]
        for form in lesson["forms"]
        for row in form["students"]
    ]  # fmt: skip
    return csv_text(STUDENT_COLUMNS, rows)


def items_csv(report: Mapping[str, Any]) -> str:
    """Numbers by item and form; full precision."""
    rows = [
        [
            lesson["lesson"], form["form"], item["id"], item["answered"], item["right"],
            item["partly"], item["wrong"], item["empty"], item["unread"], item["difficulty"],
            item["discrimination"], item["point_biserial"],
            " ".join(f"{c['option']}:{c['count']}" for c in item["choices"]),
        ]
        for lesson in report["lessons"]
        for form in lesson["forms"]
        for item in form["items"]
    ]  # fmt: skip
    return csv_text(ITEM_COLUMNS, rows)
