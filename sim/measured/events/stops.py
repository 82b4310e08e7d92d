"""A stop is short; a cart that rolls out is not stopped.

An end stop or a hand takes a cart's velocity within a few readings, or brakes it much harder than
its track did just before. A long even parabola down to rest is friction, however steep it is beside
the cart's greatest speed: with a coefficient of 0.03 a cart of 0.6 m/s rests after two seconds.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from sim.measured.rounding import EVEN, step_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from sim.measured.events.stretch import Segment

    Floats = NDArray[np.float64]

SHORT = 0.3
"""s. An end stop or a hand that is put in the way brakes for less. A track needs as little only for
less than 0.1 m/s, which is below LOST of what is filmed."""

FEW = 5
"""Cells of the search for segments: where these are wide, a stop cannot be seen to be shorter."""

LOST = 0.2
"""Of the cart's greatest speed: what a stop takes at least. The end of a parabola takes less."""

HARDER = 3.0
"""Times the deceleration just before: noise and a coefficient that changes with speed give less."""

MISSING = 0.1
"""Of the greatest speed: what the harder brake would have taken just before and did not. Of a piece
too short to tell its deceleration it is less."""

ENDS = 4
"""Readings of the motion, and of the rest after it, that show them."""

SURELY = 6.0
"""Standard deviations by which a motion that ends is more than a straight line: a cart at rest may
tremble, and its readings drift."""

NONE = 1e-9
"""m. Less is the rounding of sums: readings at rest may be all alike."""


def comes_to_rest(t: Floats, x: Floats) -> float | None:
    """s. When a slow cart that is left alone stands, where its readings show that it moved before:

        x = x_rest + c (t_rest − t)²   until t_rest, and then x_rest.

    None where a straight line does as well.
    """
    import numpy as np

    n = len(t)
    if n <= 2 * ENDS:
        return None
    ends = t[ENDS : n - ENDS, None]
    bends = np.maximum(ends - t, 0.0) ** 2
    bends -= bends.mean(axis=1, keepdims=True)
    about = x - x.mean()
    sizes = bends @ about / np.sum(bends**2, axis=1)
    left = np.sum((about - sizes[:, None] * bends) ** 2, axis=1)
    k = int(np.argmin(left))
    noise = max(float(left[k] / (n - 3)) ** 0.5, EVEN * step_of(x), NONE)
    line = float(np.sum((x - np.polyval(np.polyfit(t, x, 1), t)) ** 2))
    return float(ends[k, 0]) if line - left[k] > (SURELY * noise) ** 2 else None


def rolled_out(listed: Sequence[Segment], greatest: float, cell: float) -> list[Segment]:
    """One cart's segments in order, each stop that is only friction named so. `cell`: s."""
    short = max(SHORT, FEW * cell)
    found: list[Segment] = []
    for one in listed:
        before = found[-1] if found else None
        stopped = _short(one, short, greatest) or _harder(before, one, greatest)
        rolls = one.kind == "stop" and not stopped
        found.append(replace(one, kind="friction") if rolls else one)
    return found


def _slope_of(one: Segment) -> float:
    """m/s². How fast the size of its velocity falls."""
    lasts = one.end - one.begin
    return (abs(one.speeds[0]) - abs(one.speeds[1])) / lasts if lasts > 0.0 else 0.0


def _short(one: Segment, short: float, greatest: float) -> bool:
    lost = abs(one.speeds[0]) - abs(one.speeds[1])
    return one.end - one.begin <= short and lost > LOST * greatest


def _harder(before: Segment | None, one: Segment, greatest: float) -> bool:
    """Whether the cart ran on its own before and is now braked much harder."""
    if before is None or before.kind not in ("coasting", "friction"):
        return False
    slope, usual = _slope_of(one), max(_slope_of(before), 0.0)
    missing = (slope - usual) * (before.end - before.begin)
    return slope > HARDER * usual and missing > MISSING * greatest
