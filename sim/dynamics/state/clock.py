"""Time as the sum of two floats, so that a long run does not lose its small steps.

A million seconds of bouncing, added up in one float, is wrong by 8 micrometres of cart position;
with the rounding error of every addition carried along it is wrong by 1e-11 m.
"""

from __future__ import annotations

Time = tuple[float, float]
"""s. (hi, lo): the time is hi + lo, and hi is that sum rounded."""

ZERO: Time = (0.0, 0.0)

NEVER: Time = (float("-inf"), 0.0)
"""It has not happened so far."""

UNSEEN: Time = (float("inf"), 0.0)
"""It will not happen, as far as is foreseen."""


def later(time: Time, dt: float) -> Time:
    """`time` plus dt >= 0, with the rounding error of the addition kept (Knuth's two-sum)."""
    hi, lo = time
    total = hi + dt
    part = total - hi
    lo += (hi - (total - part)) + (dt - part)
    rounded = total + lo
    return rounded, lo - (rounded - total)


def elapsed(start: Time, end: Time) -> float:
    """Seconds from start to end."""
    return (end[0] - start[0]) + (end[1] - start[1])
