"""The gradebook of Canvas as it exports them: `Student`, `ID`, `Section`, `Force test (87568490)`.

What stands in brackets is the number that Canvas gives a test, not the most marks: these stand in a
row `Points Possible`. Above that row may be one of posting policies, which names nobody; `(read
only)` in it marks what Canvas works out by itself, and `Student, Test` is the teacher's own look at
the course. Made one of our own tables here (plain.py), which knows everything else.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from sim.classroom.tables.cells import TableError, TableRow
from sim.classroom.tables.layout import form_told, norm, split_form
from sim.classroom.tables.sentences import which_is_before

_TEST = re.compile(r"(?P<name>.+?)\s*\(\d+\)")
_MOST = "points possible"
_READ_ONLY = "(read only)"
_NOBODY = frozenset({"student, test", "test student"})


def as_plain(heads: TableRow, rows: Sequence[TableRow]) -> tuple[TableRow, Sequence[TableRow]]:
    """The same table with the columns of one of ours; any other as it is. Raises `TableError`
    where no test is told apart."""
    most = next((k for k, row in enumerate(rows) if norm(row.cells[0]) == _MOST), None)
    if most is None or [norm(head) for head in heads.cells[:2]] != ["student", "id"]:
        return heads, rows
    tests = {
        k: match["name"]
        for k, head in enumerate(heads.cells)
        if (match := _TEST.fullmatch(head)) and _cell(rows[most], k) != _READ_ONLY
    }
    forms = {k: form for k, name in tests.items() if (form := _form(name))}
    if len(set(forms.values())) < len(forms) or (not forms and len(tests) > 1):
        raise TableError(which_is_before(list(tests.values())))
    called = forms or dict.fromkeys(tests, "total")
    section = next((k for k, head in enumerate(heads.cells) if norm(head) == "section"), None)
    kept = [0, *([] if section is None else [section]), *called]
    names = ("student", *([] if section is None else ["class"]), *called.values())
    students = (row for row in rows[most:] if norm(row.cells[0]) not in _NOBODY)
    return TableRow(heads.line, names), [
        TableRow(row.line, tuple(_cell(row, k) for k in kept)) for row in students
    ]


def _form(name: str) -> str:
    return split_form(name)[0] or form_told(name)


def _cell(row: TableRow, place: int) -> str:
    """`EX`: the student was excused, and has no mark."""
    cell = row.cell(place)
    return "" if cell == "EX" else cell
