"""Units of columns: those that are read together all name one, and each one that fits."""

from __future__ import annotations

from collections.abc import Sequence

from sim.measured.refusal import ReadingError, refuse, shown
from sim.measured.sheet.table import Column, Table
from sim.scene.said import said


def check_units(table: Table, columns: Sequence[Column], example: str) -> None:
    """Raises ReadingError where one of these columns names its unit and another does not: what is
    assumed for the one may be a hundred times the other's. `example`: of a head with its unit."""
    if len({bool(column.unit) for column in columns}) > 1:
        reason = said("one column names its unit and the other does not")
        hint = said("write both heads with a unit, for example {head}", head=example)
        raise refuse(table.heads_line, reason, hint)


def no_unit(table: Table, column: Column, hint: str) -> ReadingError:
    """The unit of this column does not fit what it holds; to be raised."""
    reason = said(
        "“{unit}” is no unit that fits {column}",
        unit=shown(column.unit),
        column=shown(column.name),
    )
    return refuse(table.heads_line, reason, hint)
