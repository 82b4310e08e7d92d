"""What is said of a table of marks: rows, columns and what was left out."""

from __future__ import annotations

from collections.abc import Sequence


def rows_doubled(who: str, count: int) -> str:
    """One student twice in a table."""
    return (
        f"{who}: {count} rows of one test have this student. Are these two students, or one who "
        "took it twice? None of them is counted until you leave all but one out."
    )


def rows_equal(who: str, count: int) -> str:
    """The same row again."""
    return f"{who}: {count} rows are equal. It is counted once."


def rows_nameless(count: int) -> str:
    """Rows that do not say whose they are."""
    one = count == 1
    return (
        f"{'1 row has' if one else f'{count} rows have'} no name: "
        f"{'it counts' if one else 'each counts'} as a person of its own, and is in no pair of "
        "before and after."
    )


def left_out(columns: Sequence[str]) -> str:
    """Columns of a table that are no marks."""
    named = ", ".join(f"“{column}”" for column in columns[:8])
    more = f" and {len(columns) - 8} more" if len(columns) > 8 else ""
    return f"Columns that are not counted as marks: {named}{more}."


def worth_seen(items: Sequence[str]) -> str:
    """Where the most marks of a question are only guessed."""
    named = ", ".join(f"“{item}”" for item in items[:8])
    more = f" and {len(items) - 8} more" if len(items) > 8 else ""
    return (
        f"The table does not tell the most marks of {named}{more}: the highest mark that anybody "
        "has is taken for it. A row MAX tells them."
    )


def tests_apart(before: float, after: float) -> str:
    """Two tests that cannot be subtracted."""
    return (
        f"The test before has {before:g} marks and the test after {after:g}: no gain is computed."
    )
