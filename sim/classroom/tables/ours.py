"""Tables that the report itself saves: they are results, in which answers cannot be found again.

Read as marks, a student who took two tests would be two students, and sums questions.
"""

from __future__ import annotations

from collections.abc import Sequence

from sim.classroom.show.class_csv import ITEM_COLUMNS, STUDENT_COLUMNS
from sim.classroom.tables.cells import TableError
from sim.classroom.tables.layout import Layout, norm


def layout(heads: Sequence[str]) -> Layout | None:
    """Nothing: such a table is refused with what to drop in its place."""
    written = tuple(norm(head) for head in heads)
    for columns in (STUDENT_COLUMNS, ITEM_COLUMNS):
        if written[: len(columns)] == columns:
            raise TableError(
                "this is a table that Class results saved: give the answer files themselves, or "
                "the tables of marks that it was made from"
            )
    return None
