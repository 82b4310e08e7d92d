"""When a pair that still overlaps pushes again: a push-only one, or one that a release parted.

Its neighbours' forces change the rate d' in N = k d + c d', so N may rise through zero while d
falls. N is smooth: it is scanned while the overlap lasts, and the first rise is bisected.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from sim.dynamics.motion.guards import PUSH_ROUNDING
from sim.dynamics.state.body import Gap
from sim.laws.contact_law import ContactLaw

SCAN = 64
"""Points in one swing of the pair."""

CLOSELY = 50
"""Swings scanned at full density; a pair that drifts along with its overlap is looked at less."""

BISECTED = 1e-15
"""Relative to the span: the last bit of the time."""


def pushes(law: ContactLaw, mu: float, room: float, rate: float) -> bool:
    """Is there an overlap, and its force positive, by more than rounding?

    Between two looks a pair may clear for a moment: spring and damper of a room push nobody.
    """
    return room < 0.0 and law.force(mu, -room, -rate) > PUSH_ROUNDING * law.stiffness * -room


def is_pressed(room: float, rate: float) -> bool:
    """Does an overlap that a release parted grow? Until then its bumpers push no more."""
    return room < 0.0 and rate < 0.0


def touches_at_start(gap: Gap) -> bool:
    """Is a contact in progress when the run begins? Push-only ones may not push any more."""
    if gap.room >= 0.0 or gap.law is None:
        return False
    return not gap.law.recontacts or pushes(gap.law, gap.mu, gap.room, gap.rate)


def scan(
    is_pushing: Callable[[float, float], bool],
    swing: float,
    place: Callable[[float], tuple[float, float]],
    horizon: float,
) -> tuple[float, bool]:
    """First t at which the pair pushes, and False; or the t at which it has cleared, and True.

    inf where neither happens up to the horizon. `place` gives room and rate at t, `is_pushing` says
    of both whether they push; `swing` [s] is that of the pair over 2 pi.
    """

    def pushing(t: float) -> bool:
        return is_pushing(*place(t))

    room, rate = place(0.0)
    span = max(swing, 2.0 * -room / rate) if rate > 0.0 else swing
    before, scanned = 0.0, 0
    while before < horizon:
        scanned += 1
        if scanned > CLOSELY:  # nothing happens here quickly any more
            span *= 2.0
        span = min(span, horizon - before)
        begin = before
        for k in range(1, SCAN + 1):
            t = begin + span * k / SCAN
            if place(t)[0] >= 0.0:
                return t, True
            if pushing(t):
                return _bisected(pushing, before, t), False
            before = t
    return math.inf, False


def _bisected(pushing: Callable[[float], bool], low: float, high: float) -> float:
    """The t between low and high at which the pair begins to push, to rounding."""
    span = high - low
    while high - low > BISECTED * span:
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        low, high = (low, middle) if pushing(middle) else (middle, high)
    return high
