"""When do two neighbours touch next? Detection moves nothing.

Two free neighbours: room / closing speed, one division. Where one of them is in a contact with
its other neighbour, its motion is a formula with bounded acceleration, and the first zero of the
room is found by steps that cannot jump over it (`safe_step`).
"""

from __future__ import annotations

import math

from sim.dynamics.chain import Gap, moved, velocity
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
    fastest = gap.left.v if left is None else left.speeds(gap.left)[1]
    slowest = gap.right.v if right is None else right.speeds(gap.right)[0]
    rest = 0.0 if gap.law is None or gap.room >= 0.0 else gap.law.resting_overlap(gap.memory)
    start = gap.room + rest
    if gap.room < 0.0 and isinstance(gap.law, PushOnly):
        return _pushed_again(gap, now, horizon)
    if start > max(0.0, fastest - slowest) * horizon:
        return None

    def room(t: float) -> float:
        pulled = 0.0 if left is None else left.excess(gap.left, now, t)
        pushed = 0.0 if right is None else right.excess(gap.right, now, t)
        return start + gap.rate * t + (pushed - pulled)

    if start <= 0.0:
        if gap.rate < 0.0 or (gap.rate == 0.0 and room(PROBE * min(horizon, 1.0)) < 0.0):
            return 0.0
        if gap.rate == 0.0:
            return None
        start = 0.0
    bound = sum(
        motion.acceleration(body)
        for motion, body in ((left, gap.left), (right, gap.right))
        if motion is not None
    )
    t = 0.0
    for _ in range(SAFE_STEPS):
        here = start if t == 0.0 else room(t)
        moment = later(now, t)
        rate = gap.rate if t == 0.0 else velocity(gap.right, moment) - velocity(gap.left, moment)
        if here <= 0.0 and t > 0.0:
            return t
        step = safe_step(here, rate, bound)
        if step <= TOUCH_ROUNDING * t:
            return t if rate < 0.0 else None
        t += step
        if t > horizon:
            return None
    return t


def _pushed_again(gap: Gap, now: Time, horizon: float) -> float | None:
    """When the force of a push-only pair that still overlaps turns positive again.

    Its neighbours' forces change the rate d' in N = k d + c d', so N may rise through zero while d
    falls. N is smooth over the horizon, a small part of a swing: it is scanned and the first rise
    is bisected. A rise from zero itself is one only if N is positive at the first point.
    """
    law, mu = gap.law, gap.mu
    assert isinstance(law, PushOnly)

    def force(t: float) -> float:
        moment = later(now, t)
        rate = velocity(gap.right, moment) - velocity(gap.left, moment)
        room = gap.room + moved(gap.right, now, moment) - moved(gap.left, now, moment)
        return law.force(mu, -room, -rate) if room < 0.0 else -math.inf

    span = min(horizon, SCAN_LIMIT / math.sqrt(law.stiffness / mu))
    before = 0.0
    for k in range(1, SCAN + 1):
        t = span * k / SCAN
        if force(t) > 0.0:
            low, high = before, t
            while high - low > TOUCH_ROUNDING * span:
                middle = 0.5 * (low + high)
                low, high = (low, middle) if force(middle) > 0.0 else (middle, high)
            return high
        before = t
    return None


SCAN = 64
SCAN_LIMIT = 20.0
"""Time constants of the pair: by then the overlap left at separation is clear."""
