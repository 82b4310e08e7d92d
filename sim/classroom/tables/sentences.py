"""What is said of a table of marks: rows, columns and what was left out."""

from __future__ import annotations

from collections.abc import Sequence

from sim.classroom.tables.marks import shown
from sim.scene.said import counted, said, template

MOST_NAMED = 8
"""Columns that a note names."""
TESTS_NAMED = 4
WHERE_MOST = template(
    "The most marks of a test can stand in its heading, as in “pre (30)”, or in a row MAX."
)


def which_is_before(tests: Sequence[str]) -> str:
    """Several tests of one course, and nothing that tells them apart."""
    return said(
        "which of these tests is before, and which after: {tests}? Write pre and post above "
        "their columns, and leave the others out",
        tests=", ".join(f"“{name}”" for name in tests[:TESTS_NAMED]),
    )


def rows_doubled(who: str, count: int) -> str:
    """One student twice in a table."""
    return said(
        "{who}: {n} rows of one test have this student. Are these two students, or one who took it "
        "twice? None of them is counted until you leave all but one out.",
        who=who, n=f"{count}",
    )  # fmt: skip


def rows_equal(who: str, count: int) -> str:
    """The same row again."""
    return said("{who}: {n} rows are equal. It is counted once.", who=who, n=f"{count}")


def rows_nameless(count: int) -> str:
    """Rows that do not say whose they are."""
    return counted(
        "1 row has no name: it counts as a person of its own, and is paired with no other row.",
        "{n} rows have no name: each counts as a person of its own, and is paired with no other "
        "row.",
        n=count,
    )


def left_out(columns: Sequence[str]) -> str:
    """Columns of a table that are no marks."""
    return said("Columns that are not counted as marks: {columns}.", columns=_named(columns))


def no_student(row: str, name: str, kind: str) -> str:
    """What a row is taken for, by its kind: somebody may be called so, or not."""
    if kind == "key":
        return said("{row}: “{name}” is taken for the row of right answers, not for a student.",
                    row=row, name=shown(name))  # fmt: skip
    if kind == "most":
        return said("{row}: “{name}” is taken for the row of the most marks, not for a student.",
                    row=row, name=shown(name))  # fmt: skip
    if kind == "student":
        return said(
            "{row}: “{name}” counts as a student. The row of right answers is called KEY, that of "
            "the most marks MAX, in capitals and without a group.",
            row=row, name=shown(name),
        )  # fmt: skip
    return said("{row}: “{name}” is taken for a row of sums or means, not for a student.",
                row=row, name=shown(name))  # fmt: skip


def most_told(headings: Sequence[str]) -> str:
    """Headings whose number counts as the most marks."""
    return said("The headings tell the most marks: {headings}.", headings=_named(headings))


def most_not_told(headings: Sequence[str]) -> str:
    """Headings whose number is no maximum: a year, a day, or less than marks in the column."""
    return said("The number in a heading is not taken for the most marks: {headings}.",
                headings=_named(headings))  # fmt: skip


def worth_seen(items: Sequence[str]) -> str:
    """Where the most marks of a question are only guessed."""
    return said(
        "The table does not tell the most marks of {items}: the highest mark that anybody has is "
        "taken for it. A row MAX tells them.",
        items=_named(items),
    )


def _named(names: Sequence[str]) -> str:
    """The first names, and how many more there are."""
    named = ", ".join(f"“{name}”" for name in names[:MOST_NAMED])
    more = len(names) - MOST_NAMED
    return said("{names} and {n} more", names=named, n=f"{more}") if more > 0 else named
