"""The report on tables of marks: that of answer files, with one lesson named after the table."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

from sim.classroom.report.flags.flag import Flag
from sim.classroom.report.numerals import in_order
from sim.classroom.statistics.spread import Exact
from sim.classroom.summary.document import Read, document
from sim.classroom.summary.form_rows import plain
from sim.classroom.summary.lesson_rows import Who
from sim.classroom.summary.sums import LessonSums
from sim.classroom.tables import sentences as say
from sim.classroom.tables.judged import judged
from sim.classroom.tables.sums import lesson_of
from sim.classroom.tables.taken import WORTH_SEEN, MarkTable, Taken


@dataclass(frozen=True, slots=True)
class Judged:
    """Tables as one lesson: its sums, the rows that count, and what is to be said about them."""

    lesson: LessonSums
    groups: tuple[str, ...]
    taken: tuple[Taken, ...]
    rows: int
    set_aside: tuple[str, ...]
    refused: tuple[tuple[str, str], ...]
    flags: tuple[Flag, ...]
    notes: tuple[str, ...]


def judge(
    name: str,
    tables: Sequence[MarkTable],
    elsewhere: Callable[[Taken], str],
    *,
    most: Exact | None = None,
) -> Judged:
    """The sums of tables, which are read as one; `most`: the most marks of totals.

    `elsewhere`: the group of a row where no table has a column of groups.
    """
    everything = [row for table in tables for row in table.taken]
    if not any(table.groups for table in tables):
        named = ((row, elsewhere(row)) for row in everything)
        everything = [replace(row, group=group, apart=group) for row, group in named]
    counted, aside, flags, refused = judged(everything, most)
    groups = tuple(dict.fromkeys(row.group for row in counted))
    keys = {item: right for table in tables for item, right in table.keyed.items()}
    letters = any(table.letters for table in tables)
    lesson = lesson_of(name, counted, groups, keys, letters=letters, most=most)
    return Judged(
        lesson, groups, tuple(counted), sum(table.rows for table in tables), tuple(aside),
        tuple(dict.fromkeys([*(bad for table in tables for bad in table.refused), *refused])),
        tuple(flags), tuple(_notes(tables, lesson, counted)),
    )  # fmt: skip


def _notes(tables: Sequence[MarkTable], lesson: LessonSums, counted: Sequence[Taken]) -> list[str]:
    notes = [note for table in tables for note in table.notes]
    notes += [say.left_out(table.left_out) for table in tables
              if table.left_out and table.kind == "plain"]  # fmt: skip
    told = {most for row in counted for most in row.most.items()}
    guessed = [
        str(meta["id"])
        for form in lesson.forms.values()
        for meta in form.items
        if (meta["id"], meta["worth"]) not in told and meta["worth"] > WORTH_SEEN
    ]
    if any(form.of is None for form in lesson.forms.values()):
        notes.append(say.WHERE_MOST)
    if guessed:
        notes.append(say.worth_seen(list(dict.fromkeys(guessed))))
    return notes


def table_report(found: Judged, *, inference: bool = True) -> dict[str, Any]:
    """The report, with the students that the table names."""
    read = Read(
        unit="rows", read=found.rows, counted=len({row.place for row in found.taken}),
        set_aside=found.set_aside, refused=found.refused,
        flags=[asdict(flag) for flag in found.flags], notes=found.notes,
    )  # fmt: skip
    return document([found.lesson], found.groups, read, _who(found), inference=inference)


def _who(found: Judged) -> Who:
    lesson = found.lesson
    students = {
        form: [
            {
                "student": row.who, "group": row.group, "file": row.place,
                "total": plain(row.marks) if lesson.forms[form].of != 0 else None,
                "open": [name for name, mark in row.items.items()
                         if mark is None and name not in row.chosen
                         and name in lesson.forms[form].counted],
                "marks": [None if mark is None else plain(mark) for mark in row.items.values()],
                "waiting": [], "foreign": [], "saved": "",
            }
            for row in sorted(
                (row for row in found.taken if row.form == form),
                key=lambda row: (found.groups.index(row.group), in_order(row.person)),
            )
        ]
        for form in lesson.forms
    }  # fmt: skip
    return Who(students, {group: _lists(found, group) for group in found.groups})


def _lists(found: Judged, group: str) -> dict[str, list[Any]]:
    """Who took both tests of a group, and who only one."""
    before, after = (
        {row.person: row for row in found.taken if row.form == form and row.group == group}
        for form in ("pre", "post")
    )
    both = sorted(before.keys() & after.keys(), key=in_order)
    return {
        "students": [before[name].who for name in both],
        "before": [float(before[name].marks) for name in both],
        "after": [float(after[name].marks) for name in both],
        "without_before": [
            after[n].who for n in sorted(after.keys() - before.keys(), key=in_order)
        ],
        "without_after": [
            before[n].who for n in sorted(before.keys() - after.keys(), key=in_order)
        ],
    }
