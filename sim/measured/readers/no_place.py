"""Columns that look like places and are none: refused, with what would help."""

from __future__ import annotations

from collections.abc import Sequence

from sim.measured.refusal import refuse, shown
from sim.measured.sheet.heads import quantity_of
from sim.measured.sheet.table import Column, Table
from sim.measured.sheet.whose import are_velocities, no_place_of_tracks
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
    with_unit = [c for c in table.columns if c.unit]
    named = (c.name for c in with_unit if quantity_of(c.name, c.unit)[0] == "acc")
    if name := next(named, ""):
        raise refuse(
            table.heads_line,
            said(
                "“{column}” is an acceleration: these columns hold no positions or forces",
                column=shown(name),
            ),
            said("of a phone export x, y and z; of carts positions or velocities"),
        )
