"""The answers and marks of a class as a table for a spreadsheet: one line for each student."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.classroom.show.numbered import numbering
from sim.classroom.show.prose import prose
from sim.lesson.csv_text import csv_text
from sim.scene.said import in_words, template

STUDENT_COLUMNS = ("lesson", "form", "group", "student", "marks", "of", "open", "to read", "file")
ITEM_COLUMNS = (
    "lesson", "form", "item", "answered by", "right", "partly", "wrong", "open", "to read",
    "difficulty", "discrimination", "point-biserial", "chosen", "asked",
)  # fmt: skip


HEADS = {
    "lesson": template("lesson"), "form": template("form"), "group": template("group"),
    "student": template("code word"), "marks": template("marks"), "of": template("most marks"),
    "open": template("left open"), "to read": template("to be read"), "file": template("file"),
    "item": template("question"), "answered by": template("answered by"),
    "right": template("answered right"), "partly": template("partly right"),
    "wrong": template("wrong"), "difficulty": template("difficulty"),
    "discrimination": template("discrimination"), "point-biserial": template("point-biserial"),
    "chosen": template("chosen"), "asked": template("text of the question"),
}  # fmt: skip
"""What a column is called in another language; programs read the English names."""

ENGLISH: Mapping[str, str] = {}


def _heads(columns: Sequence[str], words: Mapping[str, str]) -> Sequence[str]:
    return [in_words(HEADS[name], words) for name in columns] if words else columns


def students_csv(report: Mapping[str, Any], words: Mapping[str, str] = ENGLISH) -> str:
    """Marks by student and form, in all and by question; questions by the number that students see,
    also those left open. Empty where a question gives no mark, or none yet. `words`: each English
    sentence in the language."""
    forms = [(lesson, form) for lesson in report["lessons"] for form in lesson["forms"]]
    most = max((len(row["marks"]) for _, form in forms for row in form["students"]), default=0)
    rows = [
        [
            lesson["lesson"], form["form"], in_words(row["group"], words),
            in_words(row["student"], words), row["total"], form["of"],
            " ".join(numbers(row["open"])), " ".join(numbers(row["waiting"])),
            in_words(row["file"], words), *row["marks"], *[None] * (most - len(row["marks"])),
        ]
        for lesson, form in forms
        for numbers in [numbering(form)]
        for row in form["students"]
    ]  # fmt: skip
    question = in_words(HEADS["item"], words)
    asked = [f"{question} {number}" for number in range(1, most + 1)]
    return csv_text([*_heads(STUDENT_COLUMNS, words), *asked], rows)


def items_csv(report: Mapping[str, Any], words: Mapping[str, str] = ENGLISH) -> str:
    """Numbers by item and form, and what it asks; full precision."""
    rows = [
        [
            lesson["lesson"], form["form"], item["id"], item["answered"], item["right"],
            item["partly"], item["wrong"], item["empty"], item["unread"], item["difficulty"],
            item["discrimination"], item["point_biserial"],
            " ".join(f"{c['option']}:{c['count']}" for c in item["choices"]), prose(item["ask"]),
        ]
        for lesson in report["lessons"]
        for form in lesson["forms"]
        for item in form["items"]
    ]  # fmt: skip
    return csv_text(_heads(ITEM_COLUMNS, words), rows)
