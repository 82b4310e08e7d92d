"""Rows of a table that are no students: right answers, the most marks, and what sums others up.

A student may be called Max, and a group too: only the column of students tells such a row, MAX and
KEY are written in capitals, and no group or class stands beside them. Each is named in a note, and
so is who is called so and is taken for a student.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Literal

from sim.classroom.statistics.spread import Exact
from sim.classroom.tables.cells import TableError, TableRow
from sim.classroom.tables.layout import Layout, norm
from sim.classroom.tables.marks import is_nothing, mark
from sim.classroom.tables.words import (
    FIGURES,
    KEY,
    MOST,
    NAMES_OR_FIGURES,
    NAMES_TOO,
    SUMS,
)

_WITH_COUNT = re.compile(r"\s*(?:\(.*\)|%|n\s*=\s*\d+)$")
"""What stands behind the word of such a row: Mean (n = 24), Total %."""

Kind = Literal["key", "most", "sums", "student"]


@dataclass(frozen=True, slots=True)
class Columns:
    """Where such a row names itself, and which cells of it are empty then."""

    student: int | None
    beside: tuple[int | None, int | None]

    @staticmethod
    def of(layout: Layout) -> Columns:
        """Those of a table that was made wide."""
        student = layout.student[0][0] if layout.student else None
        return Columns(student, (layout.group, layout.klass))

    def named(self, row: TableRow) -> str:
        """What stands in the column of students, or in the first one where nothing does."""
        return row.cell(self.student) or row.cells[0]


@dataclass(slots=True)
class Parted:
    """The rows of a table, each kind in its order. `notes`: what their names might also mean."""

    students: list[TableRow]
    keys: list[TableRow] = field(default_factory=list)
    most: list[TableRow] = field(default_factory=list)
    notes: list[tuple[TableRow, str, Kind]] = field(default_factory=list)


def parted(rows: Sequence[TableRow], columns: Columns) -> Parted:
    """Students, and what is none."""
    kinds = [_kind(row, columns) for row in rows]
    if "sums" in kinds:
        kinds = [_kind(row, columns, FIGURES | NAMES_OR_FIGURES) for row in rows]
    students = (row for row, kind in zip(rows, kinds, strict=True) if kind in (None, "student"))
    highest = _highest(students) if "sums" in kinds else {}
    found = Parted([])
    kept = {"key": found.keys, "most": found.most, "student": found.students}
    for row, kind in zip(rows, kinds, strict=True):
        name = columns.named(row)
        if kind is None or (kind == "sums" and not _sums_up(row, name, highest)):
            found.students.append(row)
            continue
        found.notes.append((row, name, kind))
        if kind != "sums":
            kept[kind].append(row)
    return found


def _kind(row: TableRow, columns: Columns, figures: frozenset[str] = FIGURES) -> Kind | None:
    name = columns.named(row)
    word = norm(name)
    beside = any(not is_nothing(row.cell(place)) for place in columns.beside)
    if word in KEY | MOST:
        if beside or (word in NAMES_TOO and name != name.upper()):
            return "student"
        return "key" if word in KEY else "most"
    return "sums" if not beside and _alone(name) in SUMS | figures else None


def _alone(name: str) -> str:
    """The word of such a row without what stands behind it."""
    return _WITH_COUNT.sub("", norm(name))


def _sums_up(row: TableRow, name: str, highest: dict[int, Exact]) -> bool:
    """Whether they can be sums, at least the highest of each column: one may be called Sum."""
    marks = dict(_marks(row))
    if _alone(name) in FIGURES | NAMES_OR_FIGURES:
        return bool(marks)
    return bool(marks) and all(value >= highest.get(place, 0) for place, value in marks.items())


def _highest(rows: Iterable[TableRow]) -> dict[int, Exact]:
    found: dict[int, Exact] = {}
    for row in rows:
        for place, value in _marks(row):
            found[place] = max(value, found.get(place, value))
    return found


def _marks(row: TableRow) -> Iterator[tuple[int, Exact]]:
    for place, cell in enumerate(row.cells):
        try:
            value, _ = mark(cell)
        except TableError:
            continue
        if value is not None:
            yield place, value
