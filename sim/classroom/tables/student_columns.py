"""Which columns say whose a row is."""

from __future__ import annotations

from collections.abc import Sequence

from sim.classroom.tables.cells import TableRow
from sim.classroom.tables.layout import norm, place_of
from sim.classroom.tables.marks import is_mark
from sim.classroom.tables.words import (
    CLASS,
    FAMILY,
    GIVEN,
    GROUP,
    ITEM,
    MARK,
    NOTE,
    NUMBER,
    OTHER,
    STUDENT,
    TIME,
    WHO,
)

OTHERS = CLASS | GROUP | ITEM | MARK | NOTE | OTHER | TIME
"""What a first column of words may hold beside names, if its heading says so."""


def named_by(heads: Sequence[str], rows: Sequence[TableRow]) -> tuple[int, ...]:
    """The columns that name the student together; empty where none does.

    A code word goes before a name, a name before a number: that may count the answers only, and
    number 3 of two tests, or of two classes, is no one student.
    """
    code = place_of(heads, ("student", "code word"))
    if code is not None:
        return (code,)
    family, given = place_of(heads, FAMILY), place_of(heads, GIVEN)
    if family is not None and given is not None:
        return (family, given)
    ways = (place_of(heads, names) for names in (STUDENT - NUMBER, WHO - NUMBER, NUMBER))
    found = next((place for place in ways if place is not None), None)
    if found is not None:
        return (found,)
    return (0,) if norm(heads[0]) not in OTHERS and _are_names(rows) else ()


def _are_names(rows: Sequence[TableRow]) -> bool:
    """Whether the first cells are words, in each row another."""
    first = [norm(row.cells[0]) for row in rows]
    return len(set(first)) == len(first) > 1 and not any(
        is_mark(cell) or len(cell) < 2 for cell in first
    )
