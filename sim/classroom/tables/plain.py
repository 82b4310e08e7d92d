"""A table that somebody made: wide or long, marks of questions or totals.

    student, group, pre, post                one row for each student, totals
    student, pre_Q1, pre_Q2, post_Q1 …       the same with a mark for each question
    student, time, Q1, Q2 …                  one row for each student and test
    student, time, total                     the same, totals
    student, item, mark                      one row for each answer

A row KEY gives right answers (letters), a row MAX the most marks; those of sums and means are not
counted (non_student_rows.py).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from sim.classroom.statistics.spread import Exact
from sim.classroom.tables.cells import TableError, TableRow
from sim.classroom.tables.column_of_tests import time_of
from sim.classroom.tables.heading_maximum import split_most, too_low, with_most
from sim.classroom.tables.layout import (
    Column,
    Layout,
    form_of,
    norm,
    place_of,
    split_form,
)
from sim.classroom.tables.marks import is_mark, is_nothing, mark
from sim.classroom.tables.non_student_rows import Columns
from sim.classroom.tables.student_columns import named_by
from sim.classroom.tables.words import CLASS, GROUP, ITEM, MARK, NOTE, OTHER, TOTAL, WHO

ADDS_UP = 0.9
"""Share of the rows in which the items add up to the total, for them to be its items."""

OTHER_NAMES = OTHER | WHO
ENOUGH = 0.5
"""Share of filled cells that must be marks or letters, for a column to be a question."""


def columns(heads: Sequence[str], rows: Sequence[TableRow]) -> Columns:
    """Who, group and class."""
    who = named_by(heads, rows)
    return Columns(who[0] if who else None, (place_of(heads, GROUP), place_of(heads, CLASS)))


def layout(heads: Sequence[str], rows: Sequence[TableRow], keys: Sequence[TableRow]) -> Layout:
    """The columns of the table; raises `TableError` where it holds no marks."""
    person = named_by(heads, (*rows, *keys))
    group, klass = place_of(heads, GROUP), place_of(heads, CLASS)
    item = place_of(heads, ITEM)
    used = {place for place in (*person, group, klass, item) if place is not None}
    time = time_of(heads, rows, used)
    used |= {time} if time is not None else set()
    rest = [k for k, head in enumerate(heads) if k not in used and norm(head) not in OTHER_NAMES]
    if item is not None:
        called = {k: norm(split_most(heads[k])[0]) for k in rest}
        marks = [k for names in (MARK, NOTE) for k in rest if called[k] in names]
        if not marks:
            raise TableError("a column of items needs one of marks beside it (mark)")
        answers = Column(marks[0], "", "", _told(heads[marks[0]], marks[0], rows)[1])
        return _made(heads, person, group, klass, time, item, (answers,), ())
    found = _single([_column(k, heads[k], rows) for k in rest], rows, keys)
    totals = tuple(c for c in found if not c.name)
    items = tuple(c for c in found if c.name and _is_item(c, rows, keys))
    if time is None and any(c.form for c in totals):
        totals = tuple(c for c in totals if c.form)
    if totals and not keys and not _adds_up(items, totals, rows):
        items = ()
    if not items and not totals:
        raise TableError(
            "no column of marks was found: pre and post, or a column for each question"
        )
    return _made(heads, person, group, klass, time, None, items, totals)


def _made(
    heads: Sequence[str], person: tuple[int, ...], group: int | None, klass: int | None,
    time: int | None, item: int | None, items: tuple[Column, ...], totals: tuple[Column, ...],
) -> Layout:  # fmt: skip
    taken = {*person, group, klass, time, item, *(c.place for c in (*items, *totals))}
    return Layout(
        kind="plain",
        student=(person,) if person else (),
        group=group, klass=klass, time=time, item=item, items=items, totals=totals,
        left_out=tuple(head for k, head in enumerate(heads) if k not in taken),
    )  # fmt: skip


def _column(place: int, heading: str, rows: Sequence[TableRow]) -> Column:
    """A total has no name: `pre`, `post (30)`, `total`; `pre (2024)` neither."""
    name, of = _told(heading, place, rows)
    if form := form_of(split_most(heading)[0]):
        return Column(place, "", form, of)
    form, inner = split_form(name)
    if norm(split_most(inner)[0]) in TOTAL:
        return Column(place, "", form, of)
    return Column(place, inner, form, of)


def _told(heading: str, place: int, rows: Sequence[TableRow]) -> tuple[str, Exact | None]:
    """What a heading names, and the most marks that it tells and its column does not deny."""
    name, of = with_most(heading)
    if of is not None and too_low(of, (row.cell(place) for row in rows)):
        return heading.strip(), None
    return name, of


def _single(
    columns: Sequence[Column], rows: Sequence[TableRow], keys: Sequence[TableRow]
) -> Sequence[Column]:
    """`FCI_pre` and `FCI_post`, one column for each test, are totals."""
    formed = [c for c in columns if c.form and (not c.name or _is_item(c, rows, keys))]
    forms = [c.form for c in formed]
    if keys or len(formed) < 2 or len(set(forms)) < len(forms):
        return columns
    return [replace(c, name="") if c in formed else c for c in columns]


def _is_item(column: Column, rows: Sequence[TableRow], keys: Sequence[TableRow]) -> bool:
    """With a row KEY every column that it fills; without, columns of marks or of single letters."""
    if keys:
        return any(row.cell(column.place) for row in keys)
    cells = [row.cell(column.place) for row in rows]
    filled = [cell for cell in cells if not is_nothing(cell)]
    good = sum(is_mark(cell) or (len(cell) == 1 and cell.isalpha()) for cell in filled)
    return bool(filled) and good >= ENOUGH * len(filled)


def _adds_up(items: Sequence[Column], totals: Sequence[Column], rows: Sequence[TableRow]) -> bool:
    """Whether the totals are those of the items: then the items tell more. Other columns of
    numbers (an earlier grade, an age) stand beside totals that they do not add up to.
    """
    if any(c.form for c in totals) and not any(c.form for c in items):
        return False
    total = totals[0]
    mine = [c for c in items if c.form == total.form]
    good = count = 0
    for row in rows:
        if is_mark(row.cell(total.place)):
            count += 1
            marks = [mark(row.cell(c.place))[0] or 0 for c in mine
                     if is_mark(row.cell(c.place))]  # fmt: skip
            good += sum(marks) == mark(row.cell(total.place))[0]
    return bool(mine) and good >= ADDS_UP * count
