"""When do two neighbours touch next? Detection moves nothing.

Two free neighbours: room / closing speed, one division. Where one of them is in a contact with
its other neighbour, its motion is a formula with bounded acceleration, and the first zero of the
room is found by steps that cannot jump over it (`safe_step`).
"""

from __future__ import annotations

import math
from collections.abc import Callable

from sim.dynamics.chain import Gap, velocity
from sim.dynamics.clock import Time, later
from sim.dynamics.laws import PushOnly
from sim.dynamics.safe_step import SAFE_STEPS, safe_step

TOUCH_ROUNDING = 1e-15
"""Relative to the search's span. A room that would close within this time has closed."""

PUSH_ROUNDING = 1e-12
"""Of k d. Spring and damper cancel at separation; what rounding leaves of them is no push."""

PROBE = 1e-2
"""Of the horizon. Neighbours that touch without closing: the sign of their room a moment later
tells whether the one is being pushed into the other. A force grows at least like t from touch."""


def next_touch(gap: Gap, now: Time, own_separation: bool = False) -> float:
    """Seconds from `now` to the touch of two free neighbours; inf if there is none in sight."""
    law = gap.law
    if gap.rate < 0.0:
        rest = 0.0 if law is None or gap.room >= 0.0 else law.resting_overlap(gap.memory)
        return max(0.0, (gap.room + rest) / -gap.rate)
    if gap.room < 0.0 and isinstance(law, PushOnly) and not own_separation:
        push = law.force(gap.mu, -gap.room, -gap.rate)
        return 0.0 if push > PUSH_ROUNDING * law.stiffness * -gap.room else math.inf
    return math.inf


def touch_during_contact(gap: Gap, now: Time) -> float | None:
    """Seconds from `now` to a touch while a body of `gap` is in another contact, or None.

    Looks no further than the end of the first of those contacts: then the gap is asked again.
    """
    left, right = gap.left.motion, gap.right.motion
    horizon = min(motion.time_left(now) for motion in (left, right) if motion is not None)
    if gap.room < 0.0 and isinstance(gap.law, PushOnly):
        return _pushed_again(gap, gap.law, now, horizon)
    fastest = gap.left.v if left is None else left.speeds(gap.left)[1]
    slowest = gap.right.v if right is None else right.speeds(gap.right)[0]
    rest = 0.0 if gap.law is None or gap.room >= 0.0 else gap.law.resting_overlap(gap.memory)
    room = gap.room + rest
    if room > max(0.0, fastest - slowest) * horizon:
        return None
    if room <= 0.0:
        soon = PROBE * min(horizon, 1.0)
        if gap.rate < 0.0 or (gap.rate == 0.0 and rest + room_at(gap, now, soon) < 0.0):
            return 0.0
        if gap.rate == 0.0:
            return None
    return _first_touch(gap, now, 0.0, horizon, rest)


def room_at(gap: Gap, now: Time, t: float) -> float:
    """m. The room of a gap t s after `now`: its present rate, and what the contacts add to it."""
    left, right = gap.left.motion, gap.right.motion
    pulled = 0.0 if left is None else left.excess(gap.left, now, t)
    pushed = 0.0 if right is None else right.excess(gap.right, now, t)
    return gap.room + gap.rate * t + (pushed - pulled)


def rate_at(gap: Gap, now: Time, t: float) -> float:
    """m/s. How fast the room grows t s after `now`."""
    if t == 0.0:
        return gap.rate
    moment = later(now, t)
    return velocity(gap.right, moment) - velocity(gap.left, moment)


def _first_touch(gap: Gap, now: Time, t: float, horizon: float, rest: float) -> float | None:
    """The first t in which room + rest is zero, from a t at which it is positive or opening."""
    bound = sum(
        body.motion.acceleration(body) for body in (gap.left, gap.right) if body.motion is not None
    )
    begin = t
    for _ in range(SAFE_STEPS):
        here = room_at(gap, now, t) + rest
        if here <= 0.0 and t > begin:
            return t
        rate = rate_at(gap, now, t)
        step = safe_step(max(here, 0.0), rate, bound)
        if step <= TOUCH_ROUNDING * t:
            return t if rate < 0.0 else None
        t += step
        if t > horizon:
            return None
    return t


def _pushed_again(gap: Gap, law: PushOnly, now: Time, horizon: float) -> float | None:
    """When a push-only pair that still overlaps pushes again.

    Its neighbours' forces change the rate d' in N = k d + c d', so N may rise through zero while d
    falls. N is smooth: it is scanned while the overlap lasts, and the first rise is bisected.
    Once the overlap is clear, the next touch is an ordinary one.
    """
    mu = gap.mu

    def force(t: float) -> float:
        return law.force(mu, -room_at(gap, now, t), -rate_at(gap, now, t))

    swing = math.sqrt(mu / law.stiffness)
    span = max(swing, 2.0 * -gap.room / gap.rate) if gap.rate > 0.0 else swing
    before = 0.0
    while before < horizon:
        span = min(span, horizon - before)
        begin = before
        for k in range(1, SCAN + 1):
            t = begin + span * k / SCAN
            if room_at(gap, now, t) >= 0.0:
                return _first_touch(gap, now, t, horizon, 0.0)
            if force(t) > PUSH_ROUNDING * law.stiffness * -gap.room:
                return _bisected(force, before, t)
            before = t
    return None


def _bisected(force: Callable[[float], float], low: float, high: float) -> float:
    """The t between low and high at which a force turns positive, to rounding."""
    span = high - low
    while high - low > TOUCH_ROUNDING * span:
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        low, high = (low, middle) if force(middle) > 0.0 else (middle, high)
    return high


SCAN = 64
"""Points in one swing of the pair."""
