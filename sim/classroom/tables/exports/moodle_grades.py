"""Moodle's grades of a course as it exports them: `Quiz: Before (Real)`, `Course total (Real)`.

One column for each test, whose name says which it is; how many marks each could have does not
stand in it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from sim.classroom.tables.cells import TableError
from sim.classroom.tables.exports.moodle import person_of
from sim.classroom.tables.layout import Column, Layout, form_told, place_of
from sim.classroom.tables.sentences import which_is_before
from sim.classroom.tables.words import CLASS, GROUP

_GRADE = re.compile(
    r"(?P<what>[^:]{2,24}):\s*(?P<name>.+?)\s*"
    r"[(（](?:real|punkte|brut|nota real|calificación|puntos|sebenar|实际分数|实分)[)）]",
    re.IGNORECASE,
)
_QUIZ = re.compile(r"quiz|test|cuestionario|kuiz|测验|வினாடி வினா", re.IGNORECASE)


def layout(heads: Sequence[str]) -> Layout | None:
    """The columns of such an export, or None; raises `TableError` where no test is told apart."""
    found = [(k, match) for k, head in enumerate(heads) if (match := _GRADE.fullmatch(head))]
    person = person_of(heads)
    if not found or not person:
        return None
    tests = [one for one in found if _QUIZ.search(one[1]["what"])] or found
    forms = [form_told(match["name"]) for _, match in tests]
    columns = [Column(k, "", form) for (k, _), form in zip(tests, forms, strict=True) if form] or [
        Column(k, "") for k, _ in tests
    ]
    if len({column.form for column in columns}) < len(columns):
        raise TableError(which_is_before([match["name"] for _, match in tests]))
    return Layout(
        kind="moodle",
        student=person,
        group=place_of(heads, GROUP),
        klass=place_of(heads, CLASS),
        totals=tuple(columns),
    )
