"""The rows above the numbers of a table: heads of columns, names of tracks, runs.

Tracker writes, for one track and for several:

    mass_A                    #multi:
    t <tab> x <tab> y         <tab> mass_A <tab> <tab> mass_B
    0,0 ...                   t <tab> x <tab> y <tab> x <tab> y

The heads are the last row before the numbers, names of tracks the row above; a row that holds
nothing but units may stand between. Without heads the columns are t, x of A, x of B.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from sim.measured.refusal import refuse
from sim.measured.sheet.cells import CellRow
from sim.measured.sheet.heads import quantity_of
from sim.measured.sheet.prefixes import parted, run_alone
from sim.measured.units import head
from sim.scene.said import said


@dataclass(frozen=True, slots=True)
class Head:
    """What stands above one column; each part may be empty."""

    name: str
    unit: str = ""
    track: str = ""
    run: str = ""


def heads_of(above: Sequence[CellRow], multi: bool) -> tuple[list[Head], int]:
    """The heads of all columns, and their line; none, where no row is one."""
    if not above:
        return [], 1
    rows = list(above)
    own_units: tuple[str, ...] = ()
    stripped = [cell.strip("()[] ") for cell in rows[-1].cells]
    if len(rows) > 1 and stripped and all(not s or quantity_of("", s)[0] for s in stripped):
        own_units = tuple(stripped)
        rows.pop()
    heads_row = rows.pop()
    if len(heads_row.cells) < 2:
        return [], heads_row.line
    parts = parted(heads_row.cells)
    pairs = [head(text) for _, text in parts]
    names = [name for name, _ in pairs]
    units = [
        unit or (own_units[k] if k < len(own_units) else "") for k, (_, unit) in enumerate(pairs)
    ]
    runs = [run for run, _ in parts]
    named = rows[-1].cells if rows else ()
    over = [run_alone(cell) for cell in named]
    if not multi and over and all(run for run, cell in zip(over, named, strict=True) if cell):
        above_runs = _until_the_next(over, len(names))
        runs = [own or other for own, other in zip(runs, above_runs, strict=True)]
        named = ()  # what stands there are runs, and no tracks
    apart = _told_apart(names) or _owners(pairs)
    tracks = _tracks(named if multi or not apart else (), len(names), multi)
    found = zip(names, units, tracks, runs, strict=True)
    return [Head(*one) for one in found], heads_row.line


_OF_CART = re.compile(r"(.+?)[\s_]+(\w+)")
_DIRECTIONS = ("x", "y", "z", "r")  # of one cart's place or velocity


def _told_apart(names: Sequence[str]) -> bool:
    """Whether the heads name two carts themselves (x_A, x_B): what stands above is a remark."""
    found = [match.groups() for name in names if (match := _OF_CART.fullmatch(name))]
    stems = [stem for stem, cart in found if cart.lower() not in _DIRECTIONS]
    return len(stems) > len(set(stems))


def _owners(pairs: Sequence[tuple[str, str]]) -> bool:
    """The same, where the cart stands before: B: x, A: x."""
    told = [quantity_of(name, unit) for name, unit in pairs]
    return len({whose for what, whose in told if what == "pos" and whose}) > 1


def _tracks(named: Sequence[str], count: int, multi: bool) -> list[str]:
    """The track that each column belongs to: a name holds until the next one."""
    filled = [cell for cell in named if cell]
    if not filled:
        return [""] * count
    if len(filled) == 1 and not multi:  # one track, wherever its name stands
        return [filled[0].replace("_", " ")] * count
    return [name.replace("_", " ") for name in _until_the_next(named, count)]


def _until_the_next(named: Sequence[str], count: int) -> list[str]:
    found, current = [], ""
    for k in range(count):
        current = (named[k] if k < len(named) else "") or current
        found.append(current)
    return found


def no_heads(width: int, line: int) -> list[Head]:
    """The heads of a table that has none; raises ReadingError where they cannot be known."""
    if width != 3:
        raise refuse(
            line,
            said("there are {count} columns and no line that names them", count=str(width)),
            said("write a first line such as: t, x_A, x_B"),
        )
    return [Head("t"), Head("x_A"), Head("x_B")]
