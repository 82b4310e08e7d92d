"""Which row names the columns: spreadsheets often begin with a title, a date and an empty line."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from sim.classroom.tables.cells import TableError, TableRow
from sim.classroom.tables.layout import norm
from sim.classroom.tables.marks import is_mark
from sim.classroom.tables.words import WHO

LOOKED_AT = 10
"""Rows among which that of the headings is looked for."""


def from_the_heads(rows: Sequence[TableRow]) -> Sequence[TableRow]:
    """The rows from the headings on: from the first that names students; else, from the first with
    two cells. Raises `TableError` where a student stands in their place.
    """
    first = next((k for k, row in enumerate(rows) if _filled(row) > 1), 0)
    named = (k for k, row in enumerate(rows[:LOOKED_AT]) if k >= first and _names_students(row))
    start = next(named, first)
    if _is_a_student(rows[start]):
        raise TableError(
            "the first row is to name the columns: student, pre, post; here marks stand in it"
        )
    return rows[start:]


def _filled(row: TableRow) -> int:
    return sum(bool(cell) for cell in row.cells)


def _names_students(row: TableRow) -> bool:
    """A title may hold such a word beside its own, as in `name:, 7a`: headings are no marks."""
    return any(norm(cell) in WHO for cell in row.cells) and not any(
        is_mark(cell) for cell in row.cells if cell
    )


def _is_a_student(heads: TableRow) -> bool:
    """A word and then marks, which do not count questions."""
    name, *rest = heads.cells
    if not rest or norm(name) in WHO or is_mark(name) or not all(map(is_mark, rest)):
        return False
    return not _counts(rest)


def _counts(cells: Sequence[str]) -> bool:
    """Whether these can be numbers of questions: 1, 2, 3 or 2, 5, 9."""
    if not all(cell.isdecimal() for cell in cells):
        return False
    steps = [int(after) - int(before) for before, after in pairwise(cells)]
    return all(step == 1 for step in steps) or (len(cells) > 2 and min(steps) > 0)
