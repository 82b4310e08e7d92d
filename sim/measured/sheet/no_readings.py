"""Cells beside or in the place of readings: remarks (“Bemerkung”, “Notes”), and dates.

A column of remarks is left out. One whose head says time, place, velocity or force is never one: a
word there is a mistake; nor is one that holds numbers for the most part.

A spreadsheet that expects another decimal sign than the file's takes 1.62 for January 1962 and
keeps the date (“Jan 62”, “01. Mrz”, “1月2日”): only a fresh import brings the number back.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from sim.measured.sheet.cells import CellRow, is_empty
from sim.measured.sheet.head_rows import Head
from sim.measured.sheet.heads import holds_times, quantity_of
from sim.measured.sheet.whose import is_force, place_of
from sim.scene.said import said

_MONTH = (  # English, German, French and Malay; whole, for “Distance 1” and “Marker 2” are heads
    r"(?:jan(?:uar[iy]?|v(?:ier)?)?|f[eé][bv](?:ruar[iy]?|r(?:ier)?)?|m(?:a[ciy]|ar(?:ch|s)?|ärz?|rz|ei)|"
    r"a[pv]r(?:il)?|ju(?:i[nl]|illet|n[ei]?|l[iy]?|lai)|aug(?:ust)?|ao[uû]t?|ogos?|"
    r"(?:sept?|o[ck]t|nov|d[eé][cz]|dis)(?:(?:o|em)b(?:er|re))?)\.?"
)
_DATE = re.compile(
    rf"\d{{1,2}}[.\s/-]{{1,2}}{_MONTH}(?:[\s/-]+\d{{2,4}})?|{_MONTH}[\s/-]{{1,2}}\d{{1,4}}"
    r"|\d{1,2}[./-]\d{1,2}[./-](?:\d{4}|\d\d)|\d{4}-\d\d-\d\d|\d{1,2}月\d{1,2}日|\d{4}年\d{1,2}月",
    re.I,
)

ANEW = said("import the file anew with this column as text, or with the decimal sign that it has")


def is_made_date(cell: str) -> bool:
    """Whether a cell is a date without a time, which no reading is."""
    return _DATE.fullmatch(cell.strip()) is not None


def of_remarks(
    heads: Sequence[Head], data: Sequence[CellRow], is_reading: Callable[[str], bool]
) -> set[int]:
    """The places of the columns that hold remarks, from 0."""
    found = set()
    for k, head in enumerate(heads):
        cells = [row.cells[k] for row in data if k < len(row.cells)]
        filled = [cell for cell in cells if not is_empty(cell)]
        if 2 * sum(map(is_reading, filled)) < len(filled) and not _says(head):
            found.add(k)
    return found


def _says(head: Head) -> bool:
    """Whether the head names something that is read."""
    one = head.name, head.unit
    known = holds_times(*one) or is_force(*one) or quantity_of(*one)[0] is not None
    return known or place_of(head.name) is not None
