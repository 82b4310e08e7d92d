"""When guards fall in a step: the first zero of each, and those that rise again.

After a trial step each guard is looked at; where one is negative, its zero is searched by shorter
trial steps or a dense output (regula falsi, Illinois variant). A guard that falls and rises again
within one step shows nothing at its ends: of a pair that closes first and opens then, the room has
its least where its rate is nought, and is there none left, the touch is before that. And bumpers
that open first and close then may have been clear in between, and remember nothing. Other guards
that rise again are not seen, nor a pair that turns round twice: a limit of all such methods.
"""

from __future__ import annotations

from collections.abc import Callable

from sim.dynamics.stepping.located import CLEAR, NEAR, Key, Located
from sim.dynamics.stepping.pairs import Pair, Row

RISING = 12
"""Looks at a guard that begins at nought, each a quarter as far into the step as the one before."""

ROUNDING = 1e-14
"""Of ways and room: what sums of them are wrong by at most."""

State = tuple[Row, Row]
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
    before, after = located.guards(t, *begin), located.guards(t + h, *end)
    roots: dict[Key, float] = {}
    for key in _crossed(before, after):
        if _lies(located, key, before[key], after[key], begin, end):
            continue
        guard = _guard(located, key, t, along)
        since, value = 0.0, before[key]
        if value <= 0.0 and (since := _risen(located, key, guard, h, begin, end, along)):
            value = guard(since)
        roots[key] = _zero(guard, since, h, value, after[key]) if value > 0.0 else 0.0
    for pair in field.pairs:
        if not pair.apart and located.idle(pair) and pair.gap not in field.joined | field.spent:
            roots |= _dip(located, pair, t, h, begin, end, along)
    field.keep = told
    first = min(roots.values(), default=h)
    return first, [key for key, root in roots.items() if root - first <= CLOSE * h]


def _risen(
    located: Located,
    key: Key,
    guard: Callable[[float], float],
    h: float,
    begin: State,
    end: State,
    along: Along,
) -> float:
    """s. When a guard of nought that begins to hold just now does so, if it does before it falls:
    of a pair that has just parted, of a cart that has just been set going. Else nought."""
    kind, number, _ = key
    if kind == "gap" and located.idle(pair := located.field.pair_at[number]):
        return _turn(located, pair, h, begin, end, along, opens=True) or 0.0
    if kind == "body" and located.field.sliding[number] and guard(0.0) == 0.0:
        parts = (h * 0.25**k for k in range(1, RISING))
        return next((part for part in parts if guard(part) > 0.0), 0.0)
    return 0.0


def _lies(
    located: Located, key: Key, before: float, after: float, begin: State, end: State
) -> bool:
    """Do two whose impact has no duration lie at each other, overlapped by rounding and no more?

    They went on with one velocity after the last impact: there is nothing left to strike.
    """
    kind, gap, _ = key
    if kind != "gap" or before > 0.0 or gap in located.field.held | located.field.spent:
        return False
    pair = located.field.pair_at[gap]
    way = max(abs(s) for row in (begin[0], end[0]) for s in row)
    return pair.force is None and before - after <= ROUNDING * (way + abs(pair.room))


def _dip(
    located: Located, pair: Pair, t: float, h: float, begin: State, end: State, along: Along
) -> dict[Key, float]:
    """When the room of a pair that is apart falls and rises again, or its overlap does."""
    field, gap = located.field, pair.gap
    if turn := _turn(located, pair, h, begin, end, along, opens=True):
        d, between, d1 = (field.overlap(pair, *at)[0] for at in (begin, along(turn), end))
        clear = field.memory[gap] and between < 0.0 < min(d, d1)
        return {(CLEAR, gap, 0): turn} if clear else {}
    if turn := _turn(located, pair, h, begin, end, along, opens=False):
        room = _guard(located, ("gap", gap, 0), t, along)
        ends, least = (room(0.0), room(h)), room(turn)
        if min(ends) > 0.0 > least:
            return {("gap", gap, 0): _zero(room, 0.0, turn, ends[0], least)}
    return {}


def _turn(
    located: Located, pair: Pair, h: float, begin: State, end: State, along: Along, *, opens: bool
) -> float | None:
    """s. When a pair turns round that first opens, or closes; None where it does not."""
    side = -1.0 if opens else 1.0

    def rate(state: State) -> float:
        return side * float(located.field.overlap(pair, *state)[1])

    first, last = rate(begin), rate(end)
    return _zero(lambda tau: rate(along(tau)), 0.0, h, first, last) if first > 0.0 > last else None


def _guard(located: Located, key: Key, t: float, along: Along) -> Callable[[float], float]:
    return lambda tau: located.guards(t + tau, *along(tau))[key]


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
