"""Touches of two on parabolas whose bumper remembers an overlap, beside forty digits."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import cast

import mpmath
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim.dynamics.loop import parabolas
from sim.dynamics.state.body import Gap
from sim.dynamics.state.clock import ZERO

ROUNDING = 1e-12
"""Relative. Of a time whose parabola may graze: the discriminant cancels to 1e-4 of its terms."""

GRAZES = 1e-8
"""Of the square of the rate: nearer to a graze rounding decides."""


def first_root(room: float, rate: float, a: float, after: mpmath.mpf) -> mpmath.mpf:
    """First t > after at which room + rate t + a t²/2 passes through nought, of forty digits."""
    square = mpmath.mpf(rate) ** 2 - 2 * mpmath.mpf(a) * room
    if square < 0:
        return mpmath.inf
    both = [(-rate + sign * mpmath.sqrt(square)) / a for sign in (1, -1)]
    found = [t for t in both if t > after * (1 + mpmath.mpf(10) ** -30)]
    return min(found, default=mpmath.inf)


@given(st.floats(1e-4, 1e-2), st.floats(0.01, 0.99), st.floats(-1.0, 1.0), st.floats(-10.0, -0.1))
def test_it_touches_where_it_rested_or_clears_and_touches_anew(
    rest: float, part: float, rate: float, a: float
) -> None:
    room = -rest * part
    for level in (room + rest, room):
        if abs(rate * rate - 2.0 * a * level) <= GRAZES * (rate * rate + abs(a) * rest):
            return
    gap = cast(Gap, SimpleNamespace(room=room, rate=rate, clear_at=None))
    found = parabolas.with_memory(gap, ZERO, rest, a, math.inf)
    with mpmath.workdps(40):
        again = first_root(room + rest, rate, a, mpmath.mpf(0))
        clear = first_root(room, rate, a, mpmath.mpf(0))
        expected = again if again < clear else first_root(room, rate, a, clear)
    assert found == pytest.approx(float(expected), rel=ROUNDING)
    assert (gap.clear_at is None) == (again < clear)
