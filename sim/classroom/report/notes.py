"""What is true of a whole report, below its tables."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.classroom.report import sentences as say
from sim.scene.said import said


def notes_of(tables: Sequence[Mapping[str, Any]]) -> list[str]:
    """What is true of the whole page."""
    apart = [(table["title"], note) for table in tables if (note := _apart(table))]
    notes: list[str] = [
        said("{name}: {says}", name=title, says=note) if len(tables) > 1 else note
        for title, note in apart
    ]
    notes += [say.ONE_ITEM] if any(form["items"] for t in tables for form in t["forms"]) else []
    tests = sum(
        bool(table.get(name))
        for lesson in tables
        for table in (*lesson["gains"], lesson["comparison"] or {}, *lesson["later"])
        for name in ("change", "wilcoxon", "welch", "adjusted")
    )
    many = say.of_many(tests)
    return [*notes, *([many] if many else [])]


def _apart(lesson: Mapping[str, Any]) -> str:
    """Why a lesson has no gains, where the tests before and after are of different marks, or nobody
    knows whether they are."""
    worth = {form["form"]: form["of"] for form in lesson["forms"]}
    if not {"pre", "post"} <= worth.keys():
        return ""
    before, after = worth["pre"], worth["post"]
    if before == after or 0 in (before, after):
        return ""
    if before is None:
        return said(
            "The most marks of the test before are not known, those of the test after are {marks}: "
            "no gain is computed.",
            marks=f"{after:g}",
        )
    if after is None:
        return said(
            "The most marks of the test after are not known, those of the test before are {marks}: "
            "no gain is computed.",
            marks=f"{before:g}",
        )
    return tests_apart(before, after)


def tests_apart(before: float, after: float) -> str:
    """Two tests that cannot be subtracted."""
    return said(
        "The test before has {before} marks and the test after {after}: no gain is computed.",
        before=f"{before:g}", after=f"{after:g}",
    )  # fmt: skip
