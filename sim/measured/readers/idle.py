"""Force sensors that were on while nothing pulled at them, beside the positions of their carts.

Smart carts write both. What lies within IDLE robust standard deviations of its median is noise and
its own zero: no push. They are told by half of the readings, and by MOST where half of them agree.
"""

from __future__ import annotations

import statistics
from collections.abc import Iterable

from sim.measured.scatter import OF_MEDIAN
from sim.measured.sheet.table import Column

IDLE = 8.0
"""Of 10⁴ normal readings none is so far off in a million files."""

MOST = 0.9
NORMAL = 1.645
"""Standard deviations within which so many normal readings lie."""


def are_idle(forces: Iterable[Column]) -> bool:
    """Does none of these sensors show a push?"""
    return not any(map(_pushes, forces))


def _pushes(force: Column) -> bool:
    told = [value for value in force.values if value is not None]
    if not told:
        return False
    middle = statistics.median(told)
    off = sorted(abs(value - middle) for value in told)
    usual = max(OF_MEDIAN * statistics.median(off), off[int(MOST * (len(off) - 1))] / NORMAL)
    return off[-1] > IDLE * usual
