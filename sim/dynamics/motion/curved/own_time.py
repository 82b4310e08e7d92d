"""A time in which a contact of spheres begins, turns and ends smoothly.

The force K d^(3/2) + C d^(1/4) d' has no power series at d = 0, and every method feels that from
far: towards a separation each of its steps is half as long as the one before. With

    z = d^(1/4) ,   dt = z³ ds   there is   dz/ds = d'/4 ,   N = K z^6 + C z d'    (units: unit_of)

and all is analytic in s: touch (z = 0 with d' > 0), greatest overlap (d' = 0) and separation, a
simple zero of z, included. A whole contact is some ten steps of a power series. Where several
touch, the one that is nearest to its touch or separation, as time goes, keeps the clock; the
others' powers of d are series as long as they overlap. One that touches without any approach cannot
keep it: z stands still there. Such changes of time are Sundman's (Stiefel & Scheifele, Linear and
Regular Celestial Mechanics, 1971). The time ds = d^(1/4) dt that makes a pair alone linear
(`sim.laws.hertz.course`) is another one: in it t itself has no series at a touch.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from sim.dynamics.motion.curved_field import curved
from sim.dynamics.motion.power_series.polynomial import Poly, slope, value, value_and_slope
from sim.dynamics.state.body import Gap
from sim.laws.rounding import LAST_BIT

NEWTON = 80
"""Steps at most, with halvings: far more than a monotone function of one variable takes."""

TENDS_NOWHERE = 1e-11
"""Of the greatest speed. A touch with less approach than that is one without approach."""


def fresh(gap: Gap, fastest: float) -> bool:
    """Does a curved contact begin just now, with a speed of approach?"""
    return gap.room >= 0.0 and -gap.rate > TENDS_NOWHERE * fastest


def keeper(gaps: list[Gap], silent: list[int]) -> int | None:
    """The gap whose contact keeps the clock; None: time itself. The `silent` ones are left out.

    Where the push of one runs through a row, all of them go back to that one's touch: it is the
    deepest of those that are about as near.
    """
    own = [k for k, gap in enumerate(gaps) if curved(gap) is not None and k not in silent]
    if not own:
        return None
    near = ABOUT * min(distance(gaps[k]) for k in own)
    return min((k for k in own if distance(gaps[k]) <= near), key=lambda k: gaps[k].room)


ABOUT = 20.0
"""Behind a push that began t ago the overlaps grow as t^2.5, t^7 …: d/d' is a part of t."""


def distance(gap: Gap) -> float:
    """s. About the time to the touch of a contact, back or ahead."""
    return max(-gap.room, 0.0) / abs(gap.rate) if gap.rate else math.inf


def unit_of(gap: Gap) -> float:
    """s/m^(3/4). dt = unit z³ ds, so that s goes up to about 1 in a step.

    z, and with it the time, changes by its own size in s = 1; from z = 0 by that of the contact.
    """
    law, over = curved(gap), max(-gap.room, 0.0)
    assert law is not None
    if over > 0.0:
        swing = math.sqrt(gap.mu / law.stiffness / math.sqrt(over))
        return float(min(distance(gap), swing) / over**0.75)
    u = -gap.rate
    lasts = (gap.mu**2 / (law.stiffness**2 * u)) ** 0.2
    return float(4.0 * (u * lasts) ** 0.25 / u)


@dataclass(frozen=True, slots=True)
class OwnTime:
    """t(s) of one step, rising; `span` is s at its end, at t = `length`."""

    at: Poly
    span: float
    length: float

    def of(self, t: float) -> float:
        """s at the time t."""
        if t <= 0.0 or t >= self.length:
            return 0.0 if t <= 0.0 else self.span
        low, high = 0.0, self.span
        touch = len(self.at) > 1 and self.at[1] == 0.0  # t grows as s⁴
        s = high * math.sqrt(math.sqrt(t / self.length)) if touch else high * t / self.length
        for _ in range(NEWTON):
            here, pace = value_and_slope(self.at, s)
            if here < t:
                low = s
            else:
                high = s
            step = (t - here) / pace if pace > 0.0 else math.inf
            if abs(step) <= LAST_BIT * s:
                return s
            s = s + step if low < s + step < high else 0.5 * (low + high)
        return s

    def time(self, s: float) -> float:
        """t at s."""
        return self.length if s >= self.span else max(value(self.at, s), 0.0)

    def pace(self, s: float) -> float:
        """dt/ds."""
        return value(slope(self.at), s)

    def until(self, s: float) -> OwnTime:
        """The same up to s."""
        return OwnTime(self.at, s, max(value(self.at, s), 0.0))
