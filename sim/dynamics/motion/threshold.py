"""When does a damped oscillation fall to a level? Closed form where there is one, else one bracket.

    z'' + 2 beta z' + w0² z = 0 ,     first t >= 0 at which z falls to `level`

Between a maximum and the next minimum z only falls, and each minimum is shallower than the one
before. So the first fall decides: the level is crossed there or never. Undamped the crossing is an
arc cosine; otherwise it is bracketed by the two turning points and found by Newton's method inside.
"""

from __future__ import annotations

import math

from sim.laws.damped_oscillation import Rate, first_turn, solve
from sim.laws.rounding import LAST_BIT

TRIES = 200
"""Halvings and Newton steps; 60 do."""


def first_fall_to(rate: Rate, z0: float, v0: float, level: float) -> float:
    """s; inf if it never does. 0 where it is at the level (or below) and falls."""
    if z0 < level:
        return 0.0
    if z0 == level:
        bend = -2.0 * rate.beta * v0 - rate.w0 * rate.w0 * z0
        if v0 < 0.0 or (v0 == 0.0 and bend < 0.0):
            return 0.0
        if v0 == 0.0 and bend == 0.0:
            return math.inf
    if rate.beta == 0.0:
        return _undamped(rate.w0, z0, v0, level)
    begin = 0.0
    rises = v0 > 0.0 or (v0 == 0.0 and z0 < 0.0)
    if rises:  # first, be it for less than a clock can tell
        begin = first_turn(rate, z0, v0)
        if begin == math.inf:
            return math.inf  # it creeps up to nought
    if not rises and v0 != 0.0:
        lowest = first_turn(rate, z0, v0)
    else:  # from one turning point to the next
        lowest = begin + math.pi / rate.w if rate.regime == "under" else math.inf
    if lowest == math.inf:
        if level <= 0.0:
            return math.inf  # it creeps down to nought
        lowest = begin + 1.0 / rate.w0
        while solve(rate, z0, v0, lowest)[0] > level:
            lowest = begin + 2.0 * (lowest - begin)
    elif solve(rate, z0, v0, lowest)[0] > level:
        return math.inf
    return _falling_root(rate, z0, v0, level, begin, lowest)


def _undamped(w: float, z0: float, v0: float, level: float) -> float:
    reach = math.hypot(z0, v0 / w)
    if abs(level) > reach:
        return math.inf
    # + 0.0: a speed of −0.0 at the lowest place would be its own next visit there
    angle = math.acos(level / reach) + math.atan2(v0 / w + 0.0, z0)
    return max(angle, 0.0) / w  # it is at or above the level: below nought is rounding


def _falling_root(rate: Rate, z0: float, v0: float, level: float, low: float, high: float) -> float:
    """Newton's method kept inside the bracket: z is above the level at low, below at high."""
    t = 0.5 * (low + high)
    for _ in range(TRIES):
        z, v = solve(rate, z0, v0, t)
        if z > level:
            low = t
        else:
            high = t
        step = t - (z - level) / v if v < 0.0 else low
        t = step if low < step < high else 0.5 * (low + high)
        if high - low <= LAST_BIT * high or t in (low, high):
            break
    return t
