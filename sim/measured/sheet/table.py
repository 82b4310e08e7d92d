"""Rows of cells as a table: heads of columns (`head_rows`), numbers with their lines."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from sim.measured.refusal import Fault, ReadingError, no_number, refuse, shown, too_large
from sim.measured.sheet import cells, signs
from sim.measured.sheet.cells import CellRow, Rows
from sim.measured.sheet.clock import seconds_of
from sim.measured.sheet.head_rows import heads_of, no_heads
from sim.measured.sheet.heads import is_time
from sim.measured.sheet.marks import is_remark, without_marks
from sim.measured.sheet.no_readings import ANEW, is_made_date, of_remarks
from sim.measured.sheet.stacked import Start, stacked, without_figures
from sim.measured.sheet.tidy import spread
from sim.measured.units import kind_of_unit, plain_unit
from sim.scene.said import Said, said, template

MOST_FAULTS = 5
"""Mistakes that are told of one file."""

_NO_ROW = (
    said("there is no row of numbers"),
    said("t and x in columns, a row for each frame"),
)


@dataclass(frozen=True, slots=True)
class Column:
    """One column. `unit` and `run` are empty where the head names none; None is an empty cell."""

    name: str
    unit: str
    track: str
    values: tuple[float | None, ...]
    run: str = ""


@dataclass(frozen=True, slots=True)
class Table:
    """Columns of one length; `lines[k]` is the line of the file that row k stands on. `starts`:
    where each of the runs that stand below each other begins."""

    columns: tuple[Column, ...]
    lines: tuple[int, ...]
    heads_line: int
    separator: str
    decimal: str
    starts: tuple[Start, ...] = ()


def read_table(text: str) -> Table:
    """The table in a text; raises ReadingError."""
    found = cells.rows_of(text)
    rows = without_figures([row for row in found.rows if not is_remark(row)])
    multi = any(_is_multi(row) for row in found.rows)
    first = next((k for half in (1, 0) for k, row in enumerate(rows) if _is_data(row, half)), None)
    if first is None:
        line = rows[0].line if rows else found.rows[0].line
        raise refuse(line, *_NO_ROW)
    above = [without_marks(row, len(rows[first].cells)) for row in rows[:first]]
    heads, heads_line = heads_of(above, multi)
    data, starts = stacked([row for row in rows[first:] if any(row.cells)], rows[:first])
    heads, data, starts = spread(heads, data, starts)
    if found.separator == "," and (fault := signs.two_readings(data[0], len(heads))):
        raise ReadingError([fault])
    signs.check_decimals(data)
    width = len(heads) or max(len(row.cells) for row in data)
    remarks = of_remarks(heads, data, _is_reading)
    heads = [replace(one, name="") if k in remarks else one for k, one in enumerate(heads)]
    numbers = _numbers(data, width, [one.name for one in heads] or None)
    if not heads:
        heads, heads_line = no_heads(width, data[0].line), data[0].line
    units = [_unit(one.name, one.unit, _first(data, k)) for k, one in enumerate(heads)]
    signs.check_thousands(data, units)
    columns = tuple(
        Column(one.name, units[k], one.track, tuple(row[k] for row in numbers), one.run)
        for k, one in enumerate(heads)
        if one.name
    )
    if not columns:
        raise refuse(data[0].line, *_NO_ROW)
    lines = tuple(row.line for row in data)
    return Table(columns, lines, heads_line, found.separator_name, _decimal(found), tuple(starts))


def _is_multi(row: CellRow) -> bool:
    return bool(row.cells) and row.cells[0].lower().startswith("#multi")


def _is_data(row: CellRow, more: int) -> bool:
    """Mostly numbers: heads have none, and a row with one bad cell is a row with a mistake. `more`:
    0 where half of the cells may be words, as in a row of a cart with its name and its run."""
    filled = [cell for cell in row.cells if not cells.is_empty(cell)]
    told = sum(_is_reading(c) or (len(filled) > 1 and is_made_date(c)) for c in filled)
    return told > 0 and 2 * told >= len(filled) + more


def _is_reading(cell: str) -> bool:
    """A number, or what is a fault in the place of one."""
    return cells.is_number(cell) or _is_clock(cell) or _has_unit(cell)


def _is_clock(cell: str) -> bool:
    return not cells.is_number(cell) and seconds_of(cell) is not None


def _has_unit(cell: str) -> bool:
    """0.35 m, or 12s."""
    match = _WITH_UNIT.fullmatch(cell)
    return match is not None and kind_of_unit(match[1]) is not None


def _first(data: Sequence[CellRow], k: int) -> str:
    """What stands first in a column."""
    return next((row.cells[k] for row in data if k < len(row.cells) and row.cells[k]), "")


def _unit(name: str, told: str, cell: str) -> str:
    """What a column is in: times of day are seconds by now, whatever its head says of them; what
    Arduino's millis() and micros() count, and what can only be milliseconds since 1970."""
    if _is_clock(cell):
        return "s"
    counted = _COUNTED.match(name.lower())
    if told or counted:
        return told or plain_unit(counted[0] if counted else "")
    since = is_time(name) and cells.is_number(cell) and cells.number_of(cell) > 1e11
    return "ms" if since else ""


_COUNTED = re.compile("millis|micros|nanos")


_WITH_UNIT = re.compile(r"[-\d.,]+ *(\D+)")


def _numbers(
    data: Sequence[CellRow], width: int, names: Sequence[str] | None
) -> list[tuple[float | None, ...]]:
    """All rows as numbers; raises with the first lines that are none. `names` of the columns, if
    there are any: one without a name is not wanted."""
    faults: list[Fault] = []
    numbers = []
    for row in data:
        if len(faults) == MOST_FAULTS:
            break
        if len(row.cells) > width:
            count = str(len(row.cells))
            reason = said("{cells} cells under {heads} heads", cells=count, heads=str(width))
            hint = said("every column needs a name of its own, and no cell a unit")
            faults.append(Fault(row.line, reason, hint))
            continue
        values: list[float | None] = []
        for k in range(width):
            cell = row.cells[k] if k < len(row.cells) else ""
            value, fault = _number(row.line, cell)
            if fault and not any(row.cells[1:]):  # words below the readings, alone in their line
                fault = replace(fault, hint=_NO_REMARK)
            if fault and names and names[k]:
                fault = _in_column(fault, names[k])
            if fault and (names is None or names[k]):
                faults.append(replace(fault, cell=cell))
                break
            values.append(value)
        numbers.append(tuple(values))
    if faults:
        raise ReadingError(faults)
    return numbers


_NO_REMARK = said("begin the line of a remark with #, or take it out")


def _in_column(fault: Fault, name: str) -> Fault:
    reason = said("{reason} (column {column})", reason=fault.reason, column=shown(name))
    return replace(fault, reason=reason)


def _number(line: int, cell: str) -> tuple[float | None, Fault | None]:
    if cells.is_empty(cell):
        return None, None
    clock = None if cells.is_number(cell) else seconds_of(cell)
    if clock is not None:
        return clock, None
    if not cells.is_number(cell):
        if _has_unit(cell):
            reason = said("a unit stands in a cell: “{cell}”", cell=shown(cell))
            hint = said("write the unit once, in the head of the column: x (cm)")
            return None, Fault(line, reason, hint)
        if is_made_date(cell):
            reason = said(
                "“{cell}” is a date: a spreadsheet has made it of a number", cell=shown(cell)
            )
            return None, Fault(line, reason, ANEW)
        return None, Fault(line, no_number(cell), said("write numbers such as 0.512"))
    value = cells.number_of(cell)
    if not math.isfinite(value):
        return None, Fault(line, *too_large(shown(cell)))
    return value, None


def _decimal(found: Rows) -> str:
    signed = (cell for _, cell in cells.numbers(found.rows) if "," in cell or "." in cell)
    return template("comma") if "," in next(signed, "") else template("point")


def of_signs(table: Table) -> Said:
    """The note of what parts the columns and the numbers."""
    return said(
        "{separator} between the columns, decimal {decimal}",
        separator=table.separator,
        decimal=table.decimal,
    )
