"""Tables with x and y of each cart: places count along the track, however the film lay."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from sim.measured import direction
from sim.measured.sheet.table import Column, Table


def along_the_track(table: Table, columns: Sequence[Column]) -> tuple[list[Column], list[str]]:
    """The columns of x, along the track where all have their y; and what to say of it."""
    beside = [_beside(table, column) for column in columns]
    paths = [
        [p for p in zip(x.values, y.values, strict=True) if None not in p]
        for x, y in zip(columns, beside, strict=True)
        if y is not None
    ]
    if len(paths) < len(columns) or not all(paths):
        return list(columns), []
    axis, note = direction.of_film(paths)  # type: ignore[arg-type]
    notes = [note] if note else []
    if axis == (1.0, 0.0):
        return list(columns), notes
    return [_turned(x, y, axis) for x, y in zip(columns, beside, strict=True) if y], notes


def _beside(table: Table, column: Column) -> Column | None:
    """The column of y of the same cart: x_A and y_A, “x” and “y” of one track."""
    name = column.name
    called = {name[:k] + "yY"[c == "X"] + name[k + 1 :] for k, c in enumerate(name) if c in "xX"}
    for one in table.columns:
        if one.name in called and (one.track, one.unit) == (column.track, column.unit):
            return one
    return None


def _turned(x: Column, y: Column, axis: direction.Vector) -> Column:
    places = zip(x.values, y.values, strict=True)
    values = (None if a is None or b is None else direction.along(axis, (a, b)) for a, b in places)
    return replace(x, values=tuple(values))
