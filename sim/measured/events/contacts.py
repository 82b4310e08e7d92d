"""When the carts pushed each other: both change their velocity at one time.

A hand or an end stop changes one cart; a contact changes both. Its trace is √|a_A a_B|, whatever
signs and zeros the sensors have. A candidate is where this stands out, and its strength
√|Δv_A Δv_B|; jitter has a trace and no strength.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from sim.measured.events.even import braked
from sim.measured.events.grid import Grid
from sim.measured.events.in_step import in_step

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

EDGE = 0.07
"""Share of the greatest trace at which a contact begins and ends."""

STANDS_OUT = 0.04
"""Share of the greatest trace of all that a candidate must reach."""

COMPARABLE = 0.4
"""Share of the greatest strength from which the earlier one is taken: later ones may be stops."""

LOUDER, FADED = 5.0, 4.0
"""Times the lower quartile of the trace: a candidate is louder, and ends where it is no more. Noise
alone is louder than the second in one cell of thirty; at half of it, in every second one, and such
a contact goes on for seconds."""

DROWNED = 0.2
"""Of the peak: a louder quartile of one side is the contact itself, in a film that ends with it."""

DIP = 0.05
"""s. A trace that comes back so soon belongs to the same contact."""

WEAKEST = 0.1
"""Share of the greatest strength from which a candidate is offered."""

SEPARATE = 0.2
"""How far apart both carts' changes may run: two stops that overlap in time are no contact."""

SAME_PLACE, PRESSED = 0.15, 0.03
"""Of the range of distances, and m: how much farther apart than at their nearest carts touch."""

SURELY = 9.0
"""Standard deviations of a velocity. Places that stand out are looked for, so noise is farther off
than usual: of 126 made films without a contact 6 still show one. A push that tells a ratio of
masses has tens."""

NEAR = 0.35
"""s. Velocities for the strength are means over at most this long."""


@dataclass(frozen=True, slots=True)
class Contact:
    """A candidate: from, middle and until in s, strength in m/s."""

    begin: float
    middle: float
    end: float
    strength: float


def contacts(grid: Grid) -> list[Contact]:
    """All of them in order of time; strength at least WEAKEST of the strongest."""
    import numpy as np

    brake = braked(grid)
    push = grid.a - brake
    trace = np.sqrt(np.abs(push[0] * push[1]))
    left = trace.copy()
    left[: grid.half + 1] = left[-grid.half - 1 :] = 0.0
    usual, spans = grid.usual(trace), list[tuple[int, int]]()
    whole = max(float(left.max()) * STANDS_OUT, LOUDER * usual)
    ahead = max(grid.half, min(2 * grid.half, round(DIP / grid.step)))
    for _ in range(12):
        peak = int(np.argmax(left))
        if left[peak] <= whole:
            break
        faint, lost = EDGE * left[peak], FADED * usual
        low, high = _edges(left, peak, ahead, max(faint, lost))
        if lost > faint:  # its ends are below the noise: a shock is as wide as what smoothed it
            low, high = min(low, peak - grid.half), max(high, peak + grid.half)
        left[max(0, low - grid.half) : high + grid.half + 1] = 0.0
        if high > low:
            spans.append((low, high))
    spans = _one_each(sorted(spans), ahead)
    found = [_candidate(grid, trace, brake, spans, k) for k in range(len(spans))]
    found = [one for one in found if one.strength > 0.0]
    strongest = max((one.strength for one in found), default=0.0)
    kept = [
        one
        for one in found
        if one.strength == strongest
        or (one.strength > WEAKEST * strongest
            and in_step(grid, one.begin, one.end).apart < SEPARATE)
    ]  # fmt: skip
    return sorted(kept, key=lambda one: one.begin)


def _one_each(spans: list[tuple[int, int]], ahead: int) -> list[tuple[int, int]]:
    """Spans in order, those joined that are no more than `ahead` cells apart: carts that catch each
    other shake."""
    found: list[tuple[int, int]] = []
    for low, high in spans:
        near = found and low - found[-1][1] <= ahead
        found.append((found.pop()[0] if near else low, high))
    return found


def _edges(trace: Floats, peak: int, ahead: int, level: float) -> tuple[int, int]:
    """Where the trace has faded: the next cell is below, and so is the mean of the next few. A dip
    (a sign that turns) is no end, nor does one loud cell of noise go on with it. Noise may be
    louder after the push than before, where a cart stood still: each side fades into its own."""
    import numpy as np

    ends = []
    for side in (trace[peak::-1], trace[peak:]):
        own = min(FADED * float(np.percentile(side, 25)), DROWNED * float(trace[peak]))
        faded = max(level, own)
        means = np.convolve(side[1:], np.ones(ahead) / ahead)[ahead - 1 :]
        over = (side[1:] > faded) | (means > faded)
        far = int(np.argmin(over)) if not over.all() else len(side) - 1
        ends.append(far)
    return peak - ends[0], peak + ends[1]


def _noise(grid: Grid, cells: int) -> list[float]:
    """m/s. Of both carts' velocities told by so many cells, on a straight line through as many."""
    told = cells + 2 * grid.half
    slope = (12.0 / (told**3 - told)) ** 0.5 / grid.step
    return [slope * one for one in grid.noise]


def _candidate(
    grid: Grid, trace: Floats, brake: Floats, spans: list[tuple[int, int]], k: int
) -> Contact:
    """Its strength by the velocities beside it, up to the next candidates; 0 where one cart's
    velocity changes by no more than its noise: one cart alone is no contact."""
    import numpy as np

    low, high = spans[k]
    near, n = max(2, round(NEAR / grid.step)), len(grid.t)
    since = max(low - near, spans[k - 1][1] if k else 0)
    until = min(high + near, spans[k + 1][0] if k + 1 < len(spans) else n - 1)
    first = slice(min(since, low - 1) if low else 0, max(low, 1))
    last = slice(min(high, n - 2) + 1, max(until, high + 1) + 1)
    change = [float(np.median(v[last]) - np.median(v[first])) for v in grid.v]
    meanwhile = slice((first.start + first.stop) // 2, (last.start + last.stop) // 2)
    even = [float(np.sum(one[meanwhile])) * grid.step for one in brake]
    middle = _weighted(grid, trace, low, high)
    sides = (_noise(grid, one.stop - one.start) for one in (first, last))
    noise = [math.hypot(*pair) for pair in zip(*sides, strict=True)]
    pushed = [abs(a - b) / SURELY for a, b in zip(change, even, strict=True)]
    both = all(one > sd for one, sd in zip(pushed, noise, strict=True))
    strength = abs(change[0] * change[1]) ** 0.5 if both else 0.0
    return Contact(float(grid.t[low]), middle, float(grid.t[high]), strength)


def middle_of(grid: Grid, begin: float, end: float) -> float:
    """s. The middle of the push between two times."""
    import numpy as np

    trace = np.sqrt(np.abs(grid.a[0] * grid.a[1]))
    low, high = (int(np.searchsorted(grid.t, one)) for one in (begin, end))
    return min(max(_weighted(grid, trace, low, min(high, len(trace) - 1)), begin), end)


def _weighted(grid: Grid, trace: Floats, low: int, high: int) -> float:
    weight, times = trace[low : high + 1], grid.t[low : high + 1]
    whole = float(weight.sum())
    return float(weight @ times / whole) if whole > 0.0 else 0.5 * float(times[0] + times[-1])


def where_near(grid: Grid, found: list[Contact]) -> list[Contact]:
    """Without those at which the carts are far apart, for places on one axis: two hands that push
    at one time are not a contact. All, where none is near: then the places are not on one axis."""
    import numpy as np

    gap = np.abs(grid.x[1] - grid.x[0])
    reach = float(gap.max() - gap.min())
    limit = float(gap.min()) + max(SAME_PLACE * reach, PRESSED)
    there = [float(np.interp(one.middle, grid.t, gap)) for one in found]
    return [one for one, at in zip(found, there, strict=True) if at <= limit] or found


def chosen(found: list[Contact], at: float | None = None) -> Contact | None:
    """The one nearest to `at`; else the first of those that are comparable with the strongest."""
    if not found:
        return None
    if at is not None:
        return min(found, key=lambda one: abs(one.middle - at))
    strongest = max(one.strength for one in found)
    return next(one for one in found if one.strength >= COMPARABLE * strongest)
