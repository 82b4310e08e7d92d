"""A table of marks read: the export is recognised, each row is judged, bad ones are named."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from sim.classroom.files.archive import shown as safe
from sim.classroom.tables import google, microsoft, moodle, plain
from sim.classroom.tables.cells import Broken, Row, TableError, rows_of
from sim.classroom.tables.layout import Column, Layout, norm
from sim.classroom.tables.long import pivoted
from sim.classroom.tables.marks import NOTHING, mark
from sim.classroom.tables.row import RowReader
from sim.classroom.tables.taken import MarkTable, Taken, place_of
from sim.classroom.tables.words import KEY, MOST
from sim.scene.said import reason_of, said

EXPORTS: tuple[Callable[[Sequence[str]], Layout | None], ...] = (
    moodle.layout,
    google.layout,
    microsoft.layout,
)
LETTERS = 2
"""Columns of letters, from which on a table without a row KEY is one of answers."""


def read_table(name: str, content: bytes, form: str = "") -> MarkTable:
    """The table; raises `TableError`. `form`: of all its rows, where the teacher says so."""
    found = list(rows_of(content))
    refused = [(row.line, row.reason) for row in found if isinstance(row, Broken)]
    rows = [row for row in found if isinstance(row, Row)]
    if not rows:
        raise TableError("there is no row in this file")
    heads, *rest = rows
    heads = Row(heads.line, tuple(safe(cell) for cell in heads.cells))
    layout = next((made for one in EXPORTS if (made := one(heads.cells))), None)
    keys = [row for row in rest if _is(row, heads, KEY)] if layout is None else []
    most = [row for row in rest if _is(row, heads, MOST)] if layout is None else []
    body = [row for row in rest if row not in keys and row not in most]
    if layout is None:
        layout = plain.layout(heads.cells, body, keys)
    if layout.item is not None:
        layout, heads, body, bad = pivoted(layout, heads, body)
        refused += bad
        keys, most = [r for r in body if _first(r) in KEY], [r for r in body if _first(r) in MOST]
        body = [row for row in body if row not in keys and row not in most]
    layout = _named(layout, most)
    reader = RowReader(layout, heads, keys, _letters(layout, body, keys), form)
    taken: list[Taken] = []
    for row in body:
        try:
            taken += tuple(reader.taken(name, row))  # all its tests, or none of them
        except TableError as error:
            refused.append((row.line, reason_of(error)))
    return MarkTable(
        name=name, kind=layout.kind, rows=len(body) + sum(isinstance(r, Broken) for r in found),
        taken=tuple(taken),
        refused=tuple((place_of(name, line), reason) for line, reason in sorted(refused)),
        left_out=layout.left_out, keyed=reader.keys, letters=reader.letters,
        groups=layout.group is not None, classes=layout.klass is not None,
    )  # fmt: skip


def _is(row: Row, heads: Row, words: frozenset[str]) -> bool:
    """Whether a row names itself so: in its first cell, or under the heading of students."""
    return any(norm(cell) in words for cell in row.cells[: len(heads.cells)][:3])


def _first(row: Row) -> str:
    return norm(row.cells[0]) if row.cells else ""


def _named(layout: Layout, most: Sequence[Row]) -> Layout:
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


def _most(column: Column, rows: Sequence[Row]) -> Column:
    for row in rows:
        if column.place < len(row.cells) and row.cells[column.place].casefold() not in NOTHING:
            try:
                return replace(column, of=mark(row.cells[column.place])[0] or None)
            except TableError as error:
                raise TableError(said(
                    "line {line}, the row of the most marks: {reason}", line=f"{row.line}",
                    reason=reason_of(error),
                )) from None  # fmt: skip
    return column


def _letters(layout: Layout, rows: Sequence[Row], keys: Sequence[Row]) -> bool:
    """Whether the cells are answers: a row KEY says so, or most columns hold letters."""
    if keys:
        return True
    if layout.kind != "plain":
        return False
    columns = [c.place for c in layout.items]
    lettered = sum(
        any(k < len(row.cells) and len(row.cells[k]) == 1 and row.cells[k].isalpha()
            for row in rows)
        for k in columns
    )  # fmt: skip
    return lettered >= LETTERS and 2 * lettered > len(columns)
