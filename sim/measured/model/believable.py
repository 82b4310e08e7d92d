"""What may be printed: finite, with a width, and possible.

An interval that is infinite, empty or none is not printed; the bounciness of two carts lies between
0 and 1, and what of its interval lies outside is cut off (all of it: not printed).
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace

from sim.measured.model.quantity import Known, Untold
from sim.scene.said import said

OPEN = said("the readings leave it open")
TOO_WIDE = said("the readings leave it open: the interval is too wide")
ABOVE = said("it comes out above 1: the carts would gain energy")

WIDEST_E = 0.5
"""Width of an interval of e that is printed: half of all that is possible."""


def bounciness(one: Known) -> Known | Untold:
    """Its interval within 0 and 1; the best value is the nearest possible one."""
    low, high = max(one.low, 0.0), min(one.high, 1.0)
    if not low < high:
        return Untold("e", one.name, ABOVE)
    if high - low > WIDEST_E:
        return Untold("e", one.name, TOO_WIDE)
    return replace(one, low=low, high=high, value=min(max(one.value, low), high))


def believable(
    known: Iterable[Known], untold: Iterable[Untold]
) -> tuple[list[Known], list[Untold]]:
    """The same without what cannot be."""
    kept: list[Known] = []
    left = list(untold)
    for given in known:
        one = given
        numbers = (one.value, one.low, one.high, one.sd)
        if one.key == "e" and all(map(math.isfinite, numbers)):
            cut = bounciness(one)
            if isinstance(cut, Untold):
                left.append(cut)
                continue
            one = cut
        if all(map(math.isfinite, numbers)) and one.low < one.high:
            kept.append(one)
        else:
            left.append(Untold(one.key, one.name, OPEN))
    return kept, left
