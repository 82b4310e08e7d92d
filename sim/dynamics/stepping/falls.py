"""When guards fall in a step: the first zero of each, and those that rise again.

After a trial step each guard is looked at; where one is negative, its zero is searched by shorter
trial steps or a dense output (regula falsi, Illinois variant). A guard that falls and rises again
within one step shows nothing at its ends: of a pair that closes first and opens then, the room has
its least where its rate is nought, and is there none left, the touch is before that. Other guards
that rise again are not seen, nor a pair that turns round twice: a limit of all such methods.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from sim.dynamics.stepping.located import NEAR, Key, Located
from sim.dynamics.stepping.pairs import Pair, Row

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
    roots = {
        key: _zero(_guard(located, key, t, along), h, before[key], after[key])
        if before[key] > 0.0
        else 0.0
        for key in _crossed(before, after)
    }
    for pair in _turning(located, begin, end):
        key = "gap", pair.gap, 0
        room = _guard(located, key, t, along)
        nearest = _nearest(located, pair, h, begin, end, along)
        if before[key] > 0.0 < after[key] and (least := room(nearest)) < 0.0:
            roots[key] = _zero(room, nearest, before[key], least)
    field.keep = told
    first = min(roots.values(), default=h)
    return first, [key for key, root in roots.items() if root - first <= CLOSE * h]


def _turning(located: Located, begin: State, end: State) -> Iterator[Pair]:
    """Pairs that are apart, close at the begin of a step and open at its end."""
    field = located.field
    for pair in field.pairs:
        if pair.apart or not located.idle(pair) or pair.gap in field.joined | field.spent:
            continue
        (_, first), (_, last) = field.overlap(pair, *begin), field.overlap(pair, *end)
        if first > 0.0 > last:
            yield pair


def _nearest(
    located: Located, pair: Pair, h: float, begin: State, end: State, along: Along
) -> float:
    """s. When a pair turns round."""

    def rate(state: State) -> float:
        return float(located.field.overlap(pair, *state)[1])

    return _zero(lambda tau: rate(along(tau)), h, rate(begin), rate(end))


def _guard(located: Located, key: Key, t: float, along: Along) -> Callable[[float], float]:
    return lambda tau: located.guards(t + tau, *along(tau))[key]


def _zero(value: Callable[[float], float], end: float, at_begin: float, at_end: float) -> float:
    """A zero of `value` between 0 and `end`, where it falls from positive to negative.

    The end of the bracket at which it is not positive any more: a formula is not left too early.
    """
    a, fa, b, fb = 0.0, at_begin, end, at_end
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
