"""phyphox: the acceleration of a phone that rides on a cart, as its CSV.

    Time (s), Linear Acceleration x (m/s^2), … y …, … z …, Absolute acceleration (m/s^2)
    Zeit (s), Lineare Beschleunigung x (m/s^2), …

Heads in other languages are known by their unit and by the letter of the axis.

The phone lies as it lies: the direction of the track is that in which it is pushed most (the first
principal axis of the accelerations), + along its largest part.
"""

from __future__ import annotations

import re

from sim.measured.direction import along, axis_of, direction_note
from sim.measured.refusal import refuse
from sim.measured.sheet.beside import check_units, no_unit
from sim.measured.sheet.heads import quantity_of
from sim.measured.sheet.table import Column, Table, read_table
from sim.measured.sheet.wrapped import counted_on
from sim.measured.track import FEWEST, Reading, Track
from sim.measured.units import Kind, Units, factor, head, of_acceleration
from sim.scene.said import said

_AXIS = re.compile(r"(?:linear\s+)?acceleration[\s_]*(?P<axis>[xyz])", re.I)
_BY_UNIT = re.compile(r"(?:.*[\s_]|a)?(?P<axis>[xyz])", re.I)
_HEAD = re.compile(r"acceleration[\s_]*x\b[^\n]*acceleration[\s_]*y\b", re.I)


def claims(text: str) -> bool:
    """Heads with accelerations along x and y, and no position."""
    lines = text[:4000].splitlines()
    found = next((line for line in lines if _HEAD.search(line) or _has_axes(line)), "")
    return bool(found) and "position" not in found.lower()


def _has_axes(line: str) -> bool:
    """Whether a line of heads has accelerations along x and y, by their units, and no places."""
    parts = [head(cell.strip(' "')) for cell in re.split(r"[\t;,]", line)]
    if not {"x", "y"} <= {_axis_of(*part) for part in parts}:
        return False
    return not any(quantity_of(*part)[0] in ("pos", "vel") for part in parts)


def _axis_of(name: str, unit: str) -> str:
    """The axis along which a column holds an acceleration; empty: it holds none."""
    by_unit = _BY_UNIT.fullmatch(name) if of_acceleration(unit) else None
    match = _AXIS.fullmatch(name) or by_unit
    return match["axis"].lower() if match else ""


def _sizes(table: Table, columns: list[Column]) -> list[float]:
    """m/s². What 1 in each of these columns is; one without a unit is in m/s²."""
    check_units(table, columns, "a_x (m/s^2)")
    sizes = []
    for column in columns:
        size = of_acceleration(column.unit or "m/s²")
        if size is None:
            raise no_unit(table, column, said("accelerations in m/s², cm/s², mm/s², g or mg"))
        sizes.append(size)
    return sizes


def read(text: str, units: Units) -> Reading:
    """One phone, along the track; raises ReadingError."""
    table, clocks = counted_on(read_table(text))
    time = next((one for one in table.columns if factor(one.unit, "time")), table.columns[0])
    found: dict[str, Column] = {}
    for column in table.columns:
        if axis_named := _axis_of(column.name, column.unit):
            found.setdefault(axis_named, column)
    if len(found) < 2:
        reason = said("no acceleration along x and y")
        raise refuse(table.heads_line, reason, said("export all columns"))
    listed = list(found.values())
    seconds = factor(time.unit or units.time, "time")
    if seconds is None:
        raise no_unit(table, time, said("time in s, ms, µs or min"))
    sizes = _sizes(table, listed)
    rows: list[tuple[float, tuple[float, float, float], int]] = []
    repeated = 0
    for k, line in enumerate(table.lines):
        t, parts = time.values[k], [column.values[k] for column in listed]
        if t is None or any(part is None for part in parts):
            continue
        if rows and t <= rows[-1][0]:
            repeated += 1
            continue
        three = [size * float(part or 0.0) for size, part in zip(sizes, parts, strict=True)]
        three += [0.0] * (3 - len(parts))
        rows.append((t, (three[0], three[1], three[2]), line))
    if len(rows) < FEWEST:
        reason = said(
            "{count} readings: at least {least} are needed", count=str(len(rows)), least=str(FEWEST)
        )
        raise refuse(table.lines[-1], reason)
    axis = axis_of([point for _, point, _ in rows])
    notes = [said("acceleration of a phone, m/s²"), direction_note(axis), *clocks]
    if repeated:
        notes.append(said("{count} rows whose time does not go on, left out", count=str(repeated)))
    a = tuple(along(axis, p) for _, p, _ in rows)
    track = Track("phone", tuple(seconds * t for t, _, _ in rows), a, tuple(r[2] for r in rows))
    assumed = frozenset[Kind](() if time.unit else ("time",))
    return Reading("acceleration", (track,), tuple(notes), assumed=assumed)
