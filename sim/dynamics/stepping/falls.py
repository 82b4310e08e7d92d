"""When guards fall in a step: the first zero of each, and those that rise again.

After a trial step each guard is looked at; where one is negative, its zero is searched by shorter
trial steps or a dense output (regula falsi, Illinois variant). A guard that falls and rises again
within one step shows nothing at its ends: of a pair that closes first and opens then, the room has
its least where its rate is nought, and is there none left, the touch is before that. And bumpers
that open first and close then may have been clear in between, and remember nothing. Other guards
that rise again are not seen, nor a pair that turns round twice: a limit of all such methods.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from sim.dynamics.stepping.located import CLEAR, NEAR, Key, Located
from sim.dynamics.stepping.pairs import Pair, PerCart

RISING = 12
"""Looks at a guard that begins at nought, each a quarter as far into the step as the one before."""

ROUNDING = 1e-14
"""Of displacements and room: what sums of them are wrong by at most."""

State = tuple[PerCart, PerCart]
"""Ways and velocities."""

Along = Callable[[float], State]
"""The state at a time [s] of a step."""

CLOSE = 1e-12
"""Of a step. Events this close to each other count as one instant."""

FINE = 1e-15
"""Of a step. How well the time of an event is searched for."""


def first_falls(
    located: Located, t: float, h: float, begin: State, end: State, along: Along
) -> tuple[float, list[Key]]:
    """When [s from t] the first guards fall in a step of h, and which; h, none: all of them hold.

    Nought where one did not hold at the begin.
    """
    field = located.field
    told, field.keep = field.keep, None  # a look is no step
    step = _Step(located, t, h, begin, end, along)
    before, after = located.guards(t, *begin), located.guards(t + h, *end)
    roots = {
        key: step.fall(key, before[key], after[key])
        for key in _crossed(before, after)
        if not step.lies(key, before[key], after[key])
    }
    for pair in field.pairs:
        if not (pair.apart or pair.gap in field.joined or pair.gap in field.spent):
            roots |= step.dip(pair) if located.idle(pair) else {}
    field.keep = told
    first = min(roots.values(), default=h)
    return first, [key for key, root in roots.items() if root - first <= CLOSE * h]


@dataclass(frozen=True, slots=True)
class _Step:
    """A trial step of h s from t: the states at its ends, and along it."""

    located: Located
    t: float
    h: float
    begin: State
    end: State
    along: Along

    def guard(self, key: Key) -> Callable[[float], float]:
        """One guard at a time [s] of the step."""
        return lambda tau: self.located.guards(self.t + tau, *self.along(tau))[key]

    def overlap(self, pair: Pair, state: State) -> tuple[float, float]:
        """d [m] and its rate [m/s]."""
        return self.located.field.overlap(pair, *state)

    def fall(self, key: Key, before: float, after: float) -> float:
        """s. When a guard falls that is negative at the end; nought where it never held."""
        guard = self.guard(key)
        since, value = 0.0, before
        if value <= 0.0 and (since := self.risen(key, value)):
            value = guard(since)
        return _zero(guard, since, self.h, value, after) if value > 0.0 else 0.0

    def risen(self, key: Key, before: float) -> float:
        """s. When a guard of nought that begins to hold just now does so, if it does before it
        falls: of a pair that has just parted, of a cart that has just been set going. Else nought.
        """
        kind, number, _ = key
        if kind == "gap" and self.located.idle(pair := self.located.field.pair_at[number]):
            return self.turn(pair) if self.overlap(pair, self.begin)[1] < 0.0 else 0.0
        if kind == "body" and self.located.field.sliding[number] and before == 0.0:
            parts = (self.h * 0.25**k for k in range(1, RISING))
            return next((part for part in parts if self.guard(key)(part) > 0.0), 0.0)
        return 0.0

    def lies(self, key: Key, before: float, after: float) -> bool:
        """Do two whose impact has no duration lie at each other, overlapped by rounding alone?

        They went on with one velocity after the last impact: there is nothing left to strike.
        """
        kind, gap, _ = key
        field = self.located.field
        if kind != "gap" or before > 0.0 or gap in field.held or gap in field.spent:
            return False
        pair = field.pair_at[gap]
        displacement = max(abs(s) for row in (self.begin[0], self.end[0]) for s in row)
        return pair.force is None and before - after <= ROUNDING * (displacement + abs(pair.room))

    def dip(self, pair: Pair) -> dict[Key, float]:
        """When the room of a pair that is apart falls and rises again, or its overlap does."""
        if not (turn := self.turn(pair)):
            return {}
        d, rate = self.overlap(pair, self.begin)
        if rate < 0.0:
            between, d1 = (self.overlap(pair, at)[0] for at in (self.along(turn), self.end))
            clear = self.located.field.memory[pair.gap] and between < 0.0 < min(d, d1)
            return {(CLEAR, pair.gap, 0): turn} if clear else {}
        key = "gap", pair.gap, 0
        room = self.guard(key)
        ends, least = (room(0.0), room(self.h)), room(turn)
        return {key: _zero(room, 0.0, turn, ends[0], least)} if min(ends) > 0.0 > least else {}

    def turn(self, pair: Pair) -> float:
        """s. When a pair turns round that closes first and opens then, or the other way; 0: not."""
        first, last = (self.overlap(pair, state)[1] for state in (self.begin, self.end))
        if not first * last < 0.0:
            return 0.0
        side = math.copysign(1.0, first)

        def rate(tau: float) -> float:
            return side * self.overlap(pair, self.along(tau))[1]

        return _zero(rate, 0.0, self.h, side * first, side * last)


def _zero(
    value: Callable[[float], float], begin: float, end: float, at_begin: float, at_end: float
) -> float:
    """A zero of `value` between `begin` and `end`, where it falls from positive to negative.

    The end of the bracket at which it is not positive any more: a formula is not left too early.
    """
    a, fa, b, fb = begin, at_begin, end, at_end
    side = 0
    for _ in range(80):
        if b - a <= FINE * end or fb == 0.0:
            break
        c = (a * fb - b * fa) / (fb - fa)
        if not a < c < b:
            c = 0.5 * (a + b)
        fc = value(c)
        if fc > 0.0:
            a, fa = c, fc
            fb = 0.5 * fb if side > 0 else fb
            side = 1
        else:
            b, fb = c, fc
            fa = 0.5 * fa if side < 0 else fa
            side = -1
    return b


def _crossed(before: dict[Key, float], after: dict[Key, float]) -> list[Key]:
    """Guards that are negative at the end of a trial step; a pair has to close before it turns."""
    return [
        key for key in before if after.get(key, 1.0) < 0.0 and (key[0] != NEAR or before[key] > 0.0)
    ]
