"""Tables of marks that were dropped on the page “Class results”, as one lesson."""

from __future__ import annotations

from base64 import b64decode
from collections.abc import Mapping, Sequence
from pathlib import PurePosixPath
from typing import Any

from sim.classroom.report.report import WHOLE
from sim.classroom.tables.cells import TableError
from sim.classroom.tables.distinct import distinct
from sim.classroom.tables.layout import form_of
from sim.classroom.tables.marks import most_of
from sim.classroom.tables.read import read_table
from sim.classroom.tables.report import judge, table_report
from sim.classroom.tables.taken import TOTALS_ONLY, MarkTable
from sim.scene.said import reason_of, said


def dropped_report(
    given: Sequence[Mapping[str, Any]], most: str, *, inference: bool
) -> dict[str, Any]:
    """The report; `given`: name, base64, form (pre, post, later or nothing) and group of each.

    What is no table is named among the files that could not be read; a bad `most` among the notes.
    """
    tables: list[MarkTable] = []
    bad: list[dict[str, str]] = []
    names = distinct([str(one["name"]) for one in given])
    groups = {name: str(one.get("group") or WHOLE) for name, one in zip(names, given, strict=True)}
    for name, one in zip(names, given, strict=True):
        form = form_of(str(one.get("form") or "")) or ""
        try:
            tables.append(read_table(name, b64decode(one["base64"]), form))
        except TableError as error:
            bad.append({"name": name, "reason": reason_of(error)})
    told, notes = None, []
    if most.strip():
        try:
            told = most_of(most)
        except TableError as error:
            notes.append(said("Most marks: {reason}.", reason=reason_of(error)))
        if told is not None and any(table.of_items for table in tables):
            told = None
            notes.append(said("Most marks: {reason}.", reason=TOTALS_ONLY))
    lesson = PurePosixPath(tables[0].name).stem if tables else ""
    found = judge(lesson, tables, lambda row: groups[row.table], most=told)
    report = table_report(found, inference=inference)
    report["files"]["refused"] = [*bad, *report["files"]["refused"]]
    report["notes"] = [*notes, *report["notes"]]
    return report
