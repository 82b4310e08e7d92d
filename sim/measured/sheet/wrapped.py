"""A clock that begins anew while the carts roll: it is counted on.

Times that are shown as minutes begin anew each hour, times of day at midnight, and what counts in
32 bits (millis(), micros()) at 2³². Such a step back is one period less than a step of the others.
A run that begins anew steps back by what the run before lasted, and that is no such period.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace

from sim.measured.refusal import in_line
from sim.measured.sheet.heads import holds_times
from sim.measured.sheet.table import Column, Table
from sim.measured.units import factor
from sim.scene.said import said

HOUR, DAY = 3600.0, 86_400.0  # s
COUNTS = 2.0**32

FITS = 3.5
"""Usual steps that are left, at most, where a period is added: some frames may be missing there."""


def counted_on(table: Table) -> tuple[Table, list[str]]:
    """The table with clocks that only go on, and notes of those that began anew."""
    columns, notes = [], []
    for column in table.columns:
        row, period = _anew(column) if holds_times(column.name, column.unit) else (0, 0.0)
        if not period:
            columns.append(column)
            continue
        line = in_line(table.lines[row])
        notes.append(said("the clock begins anew in {line} and is counted on", line=line))
        told = enumerate(column.values)
        values = (v + period if v is not None and k >= row else v for k, v in told)
        columns.append(replace(column, values=tuple(values)))
    return replace(table, columns=tuple(columns)), list(dict.fromkeys(notes))


def _anew(column: Column) -> tuple[int, float]:
    """The row at which this clock begins anew, and its period; 0 where it does not, or twice."""
    told = [(k, value) for k, value in enumerate(column.values) if value is not None]
    steps = [(k, b - a) for (_, a), (k, b) in itertools.pairwise(told)]
    back = [one for one in steps if one[1] < 0.0]
    if len(back) != 1:
        return 0, 0.0
    return back[0][0], _period(column, -back[0][1], [step for _, step in steps if step > 0.0])


def _period(column: Column, back: float, steps: Sequence[float]) -> float:
    second = factor(column.unit, "time") or 1.0
    usual = sorted(steps)[len(steps) // 2] if steps else 0.0
    periods = (HOUR / second, DAY / second, COUNTS)
    return next((one for one in periods if 0.0 < one - back <= FITS * usual), 0.0)
