"""Tables with a row for every reading of one cart, as programs of statistics keep them (“tidy”).

    cart,t,x            t,object,run,x,y
    A,0.00,0.351        0.00,red,1,0.351,0.02
    B,0.00,0.800        0.00,blue,1,0.800,0.02

Columns go side by side, a set for each cart with a clock of its own; a column of runs parts the
rows. What a column names is told by its head, a cart also by words in it. It counts only where the
time goes back without it and rises with it: readings of two carts side by side stay as they are.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import NamedTuple

from sim.measured.sheet import cells
from sim.measured.sheet.cells import CellRow
from sim.measured.sheet.clock import seconds_of
from sim.measured.sheet.head_rows import Head
from sim.measured.sheet.heads import CART_WORDS, NUMBERED, holds_times
from sim.measured.sheet.prefixes import RUN_WORDS, run_alone
from sim.measured.sheet.stacked import Start
from sim.measured.track import FEWEST

_CART = re.compile(
    rf"(?:{CART_WORDS}|car|puck|body|object|track|particle|marker|device|gleiter|körper|objekt|"
    r"mobile|objet|carrito|objeto|objek|小车|物体|滑块|வண்டி)"
    rf"(?:[\s_.-]*(?:{NUMBERED}|n°|name|label))?|id|name|label|who|which",
    re.I,
)
_RUN = re.compile(rf"(?:{RUN_WORDS}|take|repeat|次数)(?:[\s_.-]*(?:{NUMBERED}))?", re.I)
MOST_CARTS = 8
"""Different words in a column without a head that says so: more are remarks."""


class Spread(NamedTuple):
    """The table with a set of columns for each cart. `starts`: where each run begins."""

    heads: list[Head]
    data: list[CellRow]
    starts: list[Start]


def spread(heads: Sequence[Head], data: Sequence[CellRow], starts: Sequence[Start]) -> Spread:
    """The same where no column names carts or runs."""
    found = Spread(list(heads), list(data), list(starts))
    time = next((k for k, one in enumerate(heads) if holds_times(one.name, one.unit)), None)
    if time is None or len(starts) > 1 or not _backwards(data, time):
        return found
    run = _named(heads, data, _RUN)
    cart = _named(heads, data, _CART)
    if cart is None and (run is None or not _parted(data, time, [run])):
        cart = _of_words(heads, data, time, run)
    labels = [k for k in (cart, run) if k is not None]
    if not labels or not _parted(data, time, labels):
        return found
    if run is not None:
        found = _below(found, run)
    return found if cart is None else _side_by_side(found, cart, time, labels)


def _named(heads: Sequence[Head], data: Sequence[CellRow], names: re.Pattern[str]) -> int | None:
    """Where a column stands whose head is one of these names and that is filled in every row."""
    for k, head in enumerate(heads):
        if names.fullmatch(head.name.strip()) and all(_label(row, k) for row in data):
            return k
    return None


def _of_words(
    heads: Sequence[Head], data: Sequence[CellRow], time: int, run: int | None
) -> int | None:
    """The column of words, whatever its head says, without which the time goes back."""
    for k in range(len(heads)):
        told = {_label(row, k) for row in data}
        if k in (time, run) or not 2 <= len(told) <= MOST_CARTS or "" in told:
            continue
        labels = [k] if run is None else [k, run]
        if not any(map(cells.is_number, told)) and _parted(data, time, labels, slips=0.0):
            return k
    return None


SLIPS = 0.1
"""Part of the steps back in time that may be left when a column parts the rows: mistakes of typing,
which are told for their cart."""


def _parted(
    data: Sequence[CellRow], time: int, labels: Sequence[int], slips: float = SLIPS
) -> bool:
    """Whether the time rises in rows that agree in these columns, and enough of them do, twice."""
    groups: dict[tuple[str, ...], list[CellRow]] = {}
    for row in data:
        groups.setdefault(tuple(_folded(row, k) for k in labels), []).append(row)
    left = sum(_backwards(rows, time) for rows in groups.values())
    whole = sum(len(rows) >= FEWEST for rows in groups.values())
    return whole >= 2 and left <= slips * _backwards(data, time)


def _backwards(rows: Iterable[CellRow], time: int) -> int:
    """Steps in which the time does not rise."""
    told = [value for row in rows if (value := _seconds(_label(row, time))) is not None]
    return sum(a >= b for a, b in itertools.pairwise(told))


def _seconds(cell: str) -> float | None:
    return cells.number_of(cell) if cells.is_number(cell) else seconds_of(cell)


def _label(row: CellRow, k: int) -> str:
    return row.cells[k].strip() if k < len(row.cells) else ""


def _folded(row: CellRow, k: int) -> str:
    return _label(row, k).casefold()


def _below(table: Spread, run: int) -> Spread:
    """The runs below each other, in the order in which they begin."""
    runs: dict[str, list[CellRow]] = {}
    called: dict[str, str] = {}
    for row in table.data:
        name = _label(row, run)
        own = called.setdefault(name.casefold(), run_alone(name) or name)
        runs.setdefault(own, []).append(row)
    ends = list(itertools.accumulate(map(len, runs.values())))
    starts = [Start(at, name) for at, name in zip([0, *ends], runs, strict=False)]
    heads = [replace(head, name="") if k == run else head for k, head in enumerate(table.heads)]
    return Spread(heads, [row for rows in runs.values() for row in rows], starts)


def _side_by_side(table: Spread, cart: int, time: int, labels: Sequence[int]) -> Spread:
    """A set of columns for each cart, its time first; a row has its cells in the set of its own."""
    kept = [time, *(k for k in range(len(table.heads)) if k != time and k not in labels)]
    carts: dict[str, str] = {}
    for row in table.data:
        carts.setdefault(_folded(row, cart), _called(_label(row, cart)))
    places = {folded: at * len(kept) for at, folded in enumerate(carts)}
    heads = [replace(table.heads[k], track=one) for one in carts.values() for k in kept]
    data = [
        CellRow(row.line, ("",) * places[_folded(row, cart)] + tuple(_label(row, k) for k in kept))
        for row in table.data
    ]
    return Spread(heads, data, table.starts)


def _called(label: str) -> str:
    """“0.0” of a program that keeps all numbers with a point is cart 0."""
    whole = cells.is_number(label) and cells.number_of(label).is_integer()
    return str(int(cells.number_of(label))) if whole else label
