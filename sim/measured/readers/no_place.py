"""Columns that look like places and are none: refused, with what would help."""

from __future__ import annotations

from collections.abc import Sequence

from sim.measured.refusal import refuse, shown
from sim.measured.sheet.table import Column, Table
from sim.measured.sheet.whose import are_velocities, no_place_of_tracks
from sim.measured.units import is_unit, of_acceleration
from sim.scene.said import said


def no_velocities(table: Table, columns: Sequence[Column]) -> None:
    """Two columns without a unit are places, whatever they are called, but not by these words."""
    if any(column.unit for column in columns):
        return
    names = [column.name for column in columns]
    name = shown(names[0])
    if are_velocities(names):
        reason = said("“{column}” has no unit and is no place", column=name)
        hint = said("write its unit: {column} (m/s)", column=name)
        raise refuse(table.heads_line, reason, hint)
    if all(column.track for column in columns) and no_place_of_tracks(names):
        track = shown(columns[0].track)
        reason = said("“{column}” of “{cart}” is no place", column=name, cart=track)
        hint = said("in Tracker choose the columns t and x of both tracks")
        raise refuse(table.heads_line, reason, hint)


def no_accelerations(table: Table) -> None:
    """Accelerations of a phone are read along all its axes; those of carts tell no place."""
    named = (c.name for c in table.columns if of_acceleration(c.unit) is not None)
    if name := next(named, ""):
        raise refuse(
            table.heads_line,
            said(
                "“{column}” is an acceleration: these columns hold no positions or forces",
                column=shown(name),
            ),
            said("of a phone export x, y and z; of carts positions or velocities"),
        )


def no_unknown_unit(table: Table) -> None:
    """What a column is in, where nobody here knows that unit."""
    if column := next((c for c in table.columns if c.unit and not is_unit(c.unit)), None):
        raise refuse(
            table.heads_line,
            said(
                "“{unit}” is no unit that is known here (column {column})",
                unit=shown(column.unit),
                column=shown(column.name),
            ),
            said("positions in m, cm or mm, velocities in m/s or cm/s, forces in N"),
        )
