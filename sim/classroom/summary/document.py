"""A report from sums: what a table of marks and added summaries have in common."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sim.classroom.files.reading import MOST_NAMED
from sim.classroom.report.notes import notes_of
from sim.classroom.report.report import FORMAT, KIND
from sim.classroom.summary.lesson_rows import NOBODYS, Who, lesson_row
from sim.classroom.summary.sums import LessonSums


@dataclass(frozen=True, slots=True, kw_only=True)
class Read:
    """What was read. `unit`: what is counted (rows, summaries); `refused`: name and reason."""

    unit: str
    read: int
    counted: int
    set_aside: Sequence[str] = ()
    refused: Sequence[tuple[str, str]] = ()
    flags: Sequence[dict[str, Any]] = ()
    notes: Sequence[str] = ()


def document(
    lessons: Sequence[LessonSums],
    groups: Sequence[str],
    read: Read,
    who: Who = NOBODYS,
    *,
    inference: bool = True,
) -> dict[str, Any]:
    """The report; `who` belongs to the first lesson."""
    rows = [
        lesson_row(lesson, groups, who if k == 0 else NOBODYS, inference=inference)
        for k, lesson in enumerate(lessons)
    ]
    return {
        "format": FORMAT,
        "kind": KIND,
        "files": {
            "unit": read.unit,
            "read": read.read,
            "counted": read.counted,
            "set_aside": list(read.set_aside),
            "refused": [
                {"name": name, "reason": reason} for name, reason in read.refused[:MOST_NAMED]
            ],
            "refused_more": max(0, len(read.refused) - MOST_NAMED),
        },
        "keys": sorted(
            {f"{lesson.lesson} {form.form}" for lesson in lessons
             for form in lesson.forms.values() if form.has_key}
        ),
        "groups": list(groups),
        "inference": inference,
        "flags": list(read.flags),
        "notes": [*read.notes, *notes_of(rows)],
        "lessons": rows,
    }  # fmt: skip
