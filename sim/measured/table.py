"""Rows of cells as a table: heads of columns, names of tracks, numbers with their lines.

Tracker writes, for one track and for several:

    mass_A                    #multi:
    t <tab> x <tab> y         <tab> mass_A <tab> <tab> mass_B
    0,0 ...                   t <tab> x <tab> y <tab> x <tab> y

The heads are the last row before the numbers, names of tracks the row above; a row that holds
nothing but units may stand between. Without heads the columns are t, x of A, x of B.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

from sim.measured import cells
from sim.measured.cells import Row, Rows
from sim.measured.clock import seconds_of
from sim.measured.heads import quantity_of
from sim.measured.refusal import Fault, ReadingError, refuse, shown
from sim.measured.units import head, kind_of_unit

MOST_FAULTS = 5
"""Mistakes that are told of one file."""


@dataclass(frozen=True, slots=True)
class Column:
    """One column. `unit` is empty where the head names none; None is an empty cell."""

    name: str
    unit: str
    track: str
    values: tuple[float | None, ...]


@dataclass(frozen=True, slots=True)
class Table:
    """Columns of one length; `lines[k]` is the line of the file that row k stands on."""

    columns: tuple[Column, ...]
    lines: tuple[int, ...]
    heads_line: int
    separator: str
    decimal: str


def read_table(text: str) -> Table:
    """The table in a text; raises ReadingError."""
    found = cells.rows_of(text)
    rows = [row for row in found.rows if not _is_remark(row)]
    multi = any(_is_multi(row) for row in found.rows)
    first = next((k for k, row in enumerate(rows) if _is_data(row)), None)
    if first is None:
        line = rows[0].line if rows else found.rows[0].line
        raise refuse(line, "there is no row of numbers", "t and x in columns, a row for each frame")
    heads, units, tracks, heads_line = _heads(rows[:first], multi)
    data = rows[first:]
    if found.separator == "," and (fault := cells.two_readings(data[0], len(heads))):
        raise ReadingError([fault])
    cells.check_decimals(data)
    width = len(heads) or max(len(row.cells) for row in data)
    numbers = _numbers(data, width, [bool(name) for name in heads] or [True] * width)
    if not heads:
        heads, units, tracks = _no_heads(width, data[0].line)
        heads_line = data[0].line
    clocks = {k for k, c in enumerate(data[0].cells) if _is_clock(c)}
    units = [unit or ("s" if k in clocks else "") for k, unit in enumerate(units)]
    cells.check_thousands(data, units)
    columns = tuple(
        Column(name, unit, track, tuple(row[k] for row in numbers))
        for k, (name, unit, track) in enumerate(zip(heads, units, tracks, strict=True))
        if name
    )
    return Table(
        columns, tuple(row.line for row in data), heads_line, found.separator_name, _decimal(found)
    )


def _is_remark(row: Row) -> bool:
    """A column of running numbers may be called “#”: its row goes on."""
    first = row.cells[0] if row.cells else ""
    if first.lower().startswith("sep="):
        return True  # Excel's word for the separator
    return first.startswith(("#", "%", "//")) and not (first == "#" and len(row.cells) > 2)


def _is_multi(row: Row) -> bool:
    return bool(row.cells) and row.cells[0].lower().startswith("#multi")


def _is_data(row: Row) -> bool:
    """Mostly numbers: heads have none, and a row with one bad cell is a row with a mistake."""
    filled = [cell for cell in row.cells if not cells.is_empty(cell)]
    return 2 * sum(cells.is_number(c) or _is_clock(c) or _has_unit(c) for c in filled) > len(filled)


def _is_clock(cell: str) -> bool:
    return not cells.is_number(cell) and seconds_of(cell) is not None


def _has_unit(cell: str) -> bool:
    """0.35 m, or 12s."""
    match = _WITH_UNIT.fullmatch(cell)
    return match is not None and kind_of_unit(match[1]) is not None


def _heads(above: Sequence[Row], multi: bool) -> tuple[list[str], list[str], list[str], int]:
    """Names, units and tracks of the columns, and their line."""
    if not above:
        return [], [], [], 1
    rows = list(above)
    own_units: tuple[str, ...] = ()
    stripped = [cell.strip("()[] ") for cell in rows[-1].cells]
    if len(rows) > 1 and stripped and all(not s or quantity_of("", s)[0] for s in stripped):
        own_units = tuple(stripped)
        rows.pop()
    heads_row = rows.pop()
    if len(heads_row.cells) < 2:
        return [], [], [], heads_row.line
    pairs = [head(cell) for cell in heads_row.cells]
    names = [name for name, _ in pairs]
    units = [
        unit or (own_units[k] if k < len(own_units) else "") for k, (_, unit) in enumerate(pairs)
    ]
    named = rows[-1].cells if rows and (multi or not _told_apart(names)) else ()
    return names, units, _tracks(named, len(names), multi), heads_row.line


_WITH_UNIT = re.compile(r"[-\d.,]+ *(\D+)")
_OF_CART = re.compile(r"(.+?)[\s_]+(\w+)")
_DIRECTIONS = ("x", "y", "z", "r")  # of one cart's place or velocity


def _told_apart(names: Sequence[str]) -> bool:
    """Whether the heads name two carts themselves (x_A, x_B): what stands above is a remark."""
    found = [match.groups() for name in names if (match := _OF_CART.fullmatch(name))]
    stems = [stem for stem, cart in found if cart.lower() not in _DIRECTIONS]
    return len(stems) > len(set(stems))


def _tracks(named: Sequence[str], count: int, multi: bool) -> list[str]:
    """The track that each column belongs to: a name holds until the next one."""
    filled = [cell for cell in named if cell]
    if not filled:
        return [""] * count
    if len(filled) == 1 and not multi:  # one track, wherever its name stands
        return [filled[0].replace("_", " ")] * count
    tracks, current = [], ""
    for k in range(count):
        current = (named[k] if k < len(named) else "") or current
        tracks.append(current.replace("_", " "))
    return tracks


def _no_heads(width: int, line: int) -> tuple[list[str], list[str], list[str]]:
    if width != 3:
        raise refuse(
            line,
            f"there are {width} columns and no line that names them",
            "write a first line such as: t, x_A, x_B",
        )
    return ["t", "x_A", "x_B"], ["", "", ""], ["", "", ""]


def _numbers(
    data: Sequence[Row], width: int, wanted: Sequence[bool]
) -> list[tuple[float | None, ...]]:
    """All rows as numbers; raises with the first lines that are none."""
    faults: list[Fault] = []
    numbers = []
    for row in data:
        if len(faults) == MOST_FAULTS:
            break
        if len(row.cells) > width:
            reason = f"{len(row.cells)} cells under {width} heads"
            hint = "every column needs a name of its own, and no cell a unit"
            faults.append(Fault(row.line, reason, hint))
            continue
        values: list[float | None] = []
        for k in range(width):
            cell = row.cells[k] if k < len(row.cells) else ""
            value, fault = _number(row.line, cell)
            if fault and wanted[k]:
                faults.append(fault)
                break
            values.append(value)
        numbers.append(tuple(values))
    if faults:
        raise ReadingError(faults)
    return numbers


def _number(line: int, cell: str) -> tuple[float | None, Fault | None]:
    if cells.is_empty(cell):
        return None, None
    clock = None if cells.is_number(cell) else seconds_of(cell)
    if clock is not None:
        return clock, None
    if not cells.is_number(cell):
        if _has_unit(cell):
            hint = "write the unit once, in the head of the column: x (cm)"
            return None, Fault(line, f"a unit stands in a cell: “{shown(cell)}”", hint)
        return None, Fault(line, f"“{shown(cell)}” is not a number", "write numbers such as 0.512")
    value = cells.number_of(cell)
    if not math.isfinite(value):
        return None, Fault(line, f"{shown(cell)} is too large", "is this number a reading?")
    return value, None


def _decimal(found: Rows) -> str:
    for row in found.rows:
        for cell in row.cells:
            if cells.is_number(cell) and ("," in cell or "." in cell):
                return "comma" if "," in cell else "point"
    return "point"
