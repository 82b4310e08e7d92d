"""The marks that a teacher gave to answers in words, kept in a file of the teacher's own.

`{"format": 1, "kind": "newtons-carts-marks", marks: [{lesson, form, student, item, marks}]}`
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import Any
from unicodedata import normalize

from sim.lesson.kinds.words import MOST_MARKS
from sim.lesson.opening import FORMS

FORMAT = 1
KIND = "newtons-carts-marks"
MOST = 200_000
MOST_CHARACTERS = 30_000_000
ALLOWED = range(MOST_MARKS + 1)
MOST_NAME = 400
"""Characters. A file without a code word is named by its folders."""
PLACE = ("lesson", "form", "student", "item")

_SPACES = "\t\n\v\f\r \xa0\u1680" + "".join(map(chr, range(0x2000, 0x200B)))
_SPACES += "\u2028\u2029\u202f\u205f\u3000\ufeff"  # what is a space in JavaScript
_AND = re.compile("[+&]")
_GAPS = re.compile(f"[{_SPACES}–—−_]+")

Given = Mapping[tuple[str, str, str, str], int]
"""(lesson, form, student, item) -> marks."""


class MarksFileError(ValueError):
    """This is no file of marks that can be used; the message is for the teacher."""


def pseudonym(text: str) -> str:
    """A code word as it is compared: “blue fox 27” and “Blue–Fox–27” are BLUE-FOX-27.

    The rules of a student's browser (sim/web/src/shared/code-word.js), to the last sign: two on one
    laptop, with + or & between them, stand in one order.
    """
    parts = _AND.split(normalize("NFKC", text).upper())
    words = {_GAPS.sub("-", part.strip(_SPACES)) for part in parts}
    return "+".join(sorted(words, key=_order))


def _order(word: str) -> list[tuple[int, int]]:
    """By units of UTF-16, as JavaScript sorts: signs beyond the first plane come before U+E000."""
    return [(0xD800 if ord(sign) > 0xFFFF else ord(sign), ord(sign)) for sign in word]


def read_marks(text: str) -> Given:
    """The marks in a file; raises `MarksFileError`."""
    if len(text) > MOST_CHARACTERS:
        raise MarksFileError("this file is too large to be a file of marks")
    try:
        content = json.loads(text.removeprefix("\ufeff"))
    except (ValueError, RecursionError):
        raise MarksFileError("this file of marks is damaged") from None
    if not isinstance(content, dict) or content.get("kind") != KIND:
        raise MarksFileError("this is no file of marks")
    if content.get("format") != FORMAT:
        raise MarksFileError("this file of marks comes from another version of Newton's Carts")
    return given_marks(content.get("marks"))


def given_marks(rows: object) -> Given:
    """The marks in a list of rows; raises `MarksFileError`."""
    if not isinstance(rows, list) or len(rows) > MOST:
        raise MarksFileError("this file of marks is damaged")
    return dict(map(_row, rows))


def _row(row: object) -> tuple[tuple[str, str, str, str], int]:
    if isinstance(row, dict):
        lesson, form, student, item = (row.get(name) for name in PLACE)
        marks = row.get("marks")
        texts = (lesson, form, student, item)
        named = all(isinstance(text, str) and len(text) <= MOST_NAME for text in texts)
        good = named and form in FORMS
        if good and isinstance(marks, int) and not isinstance(marks, bool) and marks in ALLOWED:
            return (str(lesson), str(form), pseudonym(str(student)), str(item)), marks
    raise MarksFileError("a mark in this file is damaged")


def marks_file(given: Given) -> dict[str, Any]:
    """The same as plain values, to be written."""
    rows = [
        {**dict(zip(PLACE, place, strict=True)), "marks": marks}
        for place, marks in sorted(given.items())
    ]
    return {"format": FORMAT, "kind": KIND, "marks": rows}
