"""Which column says of which test a row is: by its heading, or because every row says before, after
or later in it, whatever the question was called.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from sim.classroom.tables.cells import TableRow
from sim.classroom.tables.layout import form_told, place_of
from sim.classroom.tables.words import TIME


def time_of(heads: Sequence[str], rows: Sequence[TableRow], taken: Collection[int]) -> int | None:
    """The place of the column; `taken`: those that are something else."""
    named = place_of(heads, TIME)
    if named is not None:
        return named
    free = (k for k in range(len(heads)) if k not in taken)
    return next((k for k in free if _tells(rows, k)), None)


def _tells(rows: Sequence[TableRow], place: int) -> bool:
    cells = [row.cells[place] if place < len(row.cells) else "" for row in rows]
    return len(cells) > 1 and all(map(form_told, cells))
