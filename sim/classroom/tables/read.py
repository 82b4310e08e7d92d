"""A table of marks read: the export is recognised, each row is judged, bad ones are named."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from sim.classroom.files.archive import shown as safe
from sim.classroom.tables import plain
from sim.classroom.tables import sentences as say
from sim.classroom.tables.cells import Broken, TableError, TableRow, rows_of
from sim.classroom.tables.column_of_tests import time_of
from sim.classroom.tables.exports import EXPORTS, canvas
from sim.classroom.tables.heading_maximum import split_most
from sim.classroom.tables.heading_row import from_the_heads
from sim.classroom.tables.layout import Column, Layout
from sim.classroom.tables.long import Bad, pivoted
from sim.classroom.tables.marks import is_nothing, mark
from sim.classroom.tables.non_student_rows import Columns, Parted, parted
from sim.classroom.tables.row import RowReader
from sim.classroom.tables.taken import MarkTable, Taken, place_of
from sim.scene.said import reason_of, said

LETTERS = 2
"""Columns of letters, from which on a table without a row KEY is one of answers."""


def read_table(name: str, content: bytes, form: str = "") -> MarkTable:
    """The table; raises `TableError`. `form`: of all its rows, where the teacher says so."""
    found = list(rows_of(content))
    refused = [(row.line, row.reason) for row in found if isinstance(row, Broken)]
    rows = [row for row in found if isinstance(row, TableRow)]
    if not rows:
        raise TableError("there is no row in this file")
    heads, *rest = from_the_heads(rows)
    heads = TableRow(heads.line, tuple(safe(cell) for cell in heads.cells))
    layout, heads, rows_, bad = _parted(heads, rest)
    refused += bad
    layout = _named(layout, rows_.most)
    reader = RowReader(layout, heads, rows_.keys, _letters(layout, rows_), form)
    taken: list[Taken] = []
    for row in rows_.students:
        try:
            taken += tuple(reader.taken(name, row))  # all its tests, or none of them
        except TableError as error:
            refused.append((row.line, reason_of(error)))
    return MarkTable(
        name=name, kind=layout.kind, taken=tuple(taken),
        rows=len(rows_.students) + sum(isinstance(row, Broken) for row in found),
        refused=tuple((place_of(name, line), reason) for line, reason in sorted(refused)),
        left_out=layout.left_out, keyed=reader.keys, letters=reader.letters,
        groups=layout.group is not None, classes=layout.klass is not None,
        notes=(*(say.no_student(place_of(name, row.line), word, kind)
                 for row, word, kind in rows_.notes), *_of_headings(layout, heads, reader)),
    )  # fmt: skip


def _of_headings(layout: Layout, heads: TableRow, reader: RowReader) -> Iterator[str]:
    """Which numbers of headings count as the most marks: nobody else knows what they count."""
    if layout.kind != "plain" or reader.letters:
        return
    told: dict[bool, list[str]] = {True: [], False: []}
    for column in layout.items or layout.totals:
        heading = heads.cells[column.place]
        if (number := split_most(heading)[1]) is not None and column.of in (number, None):
            told[column.of is not None].append(heading)
    if told[True]:
        yield say.most_told(told[True])
    if told[False]:
        yield say.most_not_told(told[False])


def _parted(
    heads: TableRow, rows: Sequence[TableRow]
) -> tuple[Layout, TableRow, Parted, list[Bad]]:
    """The columns, and which rows are students; a table with a row for each answer is wide now."""
    layout = next((made for one in EXPORTS if (made := one(heads.cells))), None)
    if layout is not None:
        return _with_time(layout, heads, rows), heads, Parted(list(rows)), []
    heads, rows = canvas.as_plain(heads, rows)
    found = parted(rows, plain.columns(heads.cells, rows))
    layout = plain.layout(heads.cells, found.students, found.keys)
    if layout.item is None:
        return layout, heads, found, []
    layout, heads, wide, bad = pivoted(layout, heads, rows)
    return layout, heads, parted(wide, Columns.of(layout)), bad


def _with_time(layout: Layout, heads: TableRow, rows: Sequence[TableRow]) -> Layout:
    """An export in which students said themselves whether it was before or after."""
    columns = (*layout.items, *layout.totals)
    if layout.time is not None or any(column.form for column in columns):
        return layout
    taken = {k for way in layout.student for k in way} | {column.place for column in columns}
    return replace(layout, time=time_of(heads.cells, rows, taken))


def _named(layout: Layout, most: Sequence[TableRow]) -> Layout:
    """Columns with the most marks that a row MAX tells, and no name twice in a form."""
    seen: set[tuple[str, str]] = set()
    items = []
    for column in layout.items:
        name, count = column.name[:120], 1
        while (column.form, name) in seen:
            count += 1
            name = f"{column.name[:120]} ({count})"
        seen.add((column.form, name))
        items.append(_most(replace(column, name=name), most))
    return replace(
        layout, items=tuple(items), totals=tuple(_most(column, most) for column in layout.totals)
    )


def _most(column: Column, rows: Sequence[TableRow]) -> Column:
    for row in rows:
        if not is_nothing(cell := row.cell(column.place)):
            try:
                return replace(column, of=mark(cell)[0] or None)
            except TableError as error:
                raise TableError(said(
                    "line {line}, the row of the most marks: {reason}", line=f"{row.line}",
                    reason=reason_of(error),
                )) from None  # fmt: skip
    return column


def _letters(layout: Layout, rows: Parted) -> bool:
    """Whether the cells are answers: a row KEY says so, or most columns hold mostly letters."""
    if rows.keys:
        return True
    if layout.kind != "plain":
        return False
    lettered = sum(_lettered(column, rows.students) for column in layout.items)
    return lettered >= LETTERS and 2 * lettered > len(layout.items)


def _lettered(column: Column, rows: Sequence[TableRow]) -> bool:
    """Whether most filled cells are letters: one absent student's do not make marks answers."""
    filled = [cell for row in rows if not is_nothing(cell := row.cell(column.place))]
    return 2 * sum(len(cell) == 1 and cell.isalpha() for cell in filled) > len(filled)
