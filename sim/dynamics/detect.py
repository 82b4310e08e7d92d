"""When do two neighbours touch next? Detection moves nothing.

Two free neighbours: room / closing speed, one division. Where one of them is in a contact with
its other neighbour, its motion is a closed form f(t) with bounded acceleration A, and the first
zero of the room g is found by steps that cannot jump over it:

    g(t + h) >= g + g' h − A h²/2   so a safe step is   h = 2 g / (−g' + sqrt(g'² + 2 A g))

Near a zero that is crossed with speed this is Newton's step: it converges quadratically.
"""

from __future__ import annotations

import math

from sim.dynamics.chain import Body, Gap, moved, velocity
from sim.dynamics.clock import Time, elapsed

SAFE_STEPS = 400
"""Steps of the guarded search. Ten do for a crossing; only a near miss takes more, and ends."""

TOUCH_ROUNDING = 1e-15
"""Relative to the search's span. A room that would close within this time has closed."""


def next_touch(gap: Gap, now: Time, own_separation: bool = False) -> float:
    """Seconds from `now` to the touch of two free neighbours; inf if there is none in sight."""
    law = gap.law
    if gap.rate < 0.0:
        rest = 0.0 if law is None or gap.room >= 0.0 else law.resting_overlap(gap.memory)
        return max(0.0, (gap.room + rest) / -gap.rate)
    if gap.room < 0.0 and law is not None and not own_separation:
        return 0.0 if law.pushes(gap.mu, -gap.room, -gap.rate) else math.inf
    return math.inf


def touch_during_contact(gap: Gap, now: Time) -> float | None:
    """Seconds from `now` to a touch while a body of `gap` is in another contact, or None.

    Looks no further than the end of the first of those contacts: then the gap is asked again.
    """
    horizon = min(_time_left(gap.left, now), _time_left(gap.right, now))
    closing = _bounds(gap.left)[1] - _bounds(gap.right)[0]
    rest = 0.0
    if gap.law is not None and gap.room < 0.0:
        rest = gap.law.resting_overlap(gap.memory)
    room = gap.room + rest
    if room > max(0.0, closing) * horizon:
        return None
    bound = _acceleration(gap.left) + _acceleration(gap.right)
    start, t = room, 0.0
    for _ in range(SAFE_STEPS):
        moment = (now[0] + t, now[1])
        rate = velocity(gap.right, moment) - velocity(gap.left, moment)
        room = start if t == 0.0 else _room(gap, start, now, moment)
        if room <= 0.0 and (rate < 0.0 or (t == 0.0 and rate == 0.0)):
            return t
        if t == 0.0 and room <= 0.0:
            room = 0.0
        root = math.sqrt(rate * rate + 2.0 * bound * room)
        step = (rate + root) / bound if rate > 0.0 else 2.0 * room / (root - rate)
        if step <= TOUCH_ROUNDING * min(horizon, now[0] + t + step):
            return t if rate <= 0.0 else None
        t += step
        if t > horizon:
            return None
    return t


def _room(gap: Gap, start: float, now: Time, moment: Time) -> float:
    return start + moved(gap.right, now, moment) - moved(gap.left, now, moment)


def _time_left(body: Body, now: Time) -> float:
    contact = body.contact
    return math.inf if contact is None else contact.duration - elapsed(contact.begun, now)


def _bounds(body: Body) -> tuple[float, float]:
    """Least and greatest velocity until the body's contact ends: |d'| never exceeds its bound."""
    contact = body.contact
    if contact is None:
        return body.v, body.v
    reach = _share(body) * _speed(body)
    return contact.velocity - reach, contact.velocity + reach


def _speed(body: Body) -> float:
    """m/s. Bound on |d'|: all the energy of the relative motion in the motion."""
    contact = body.contact
    assert contact is not None
    return math.hypot(contact.u, contact.d0 * math.sqrt(contact.law.stiffness / contact.mu))


def _share(body: Body) -> float:
    contact = body.contact
    assert contact is not None
    return contact.shares[0] if contact.gap == body.right else contact.shares[1]


def _acceleration(body: Body) -> float:
    """m/s². Bound on the body's acceleration in its contact."""
    contact = body.contact
    if contact is None:
        return 0.0
    _, force, _ = contact.peak()
    pull = 0.0
    if contact.stretches:
        a = contact.at(min(contact.duration, 1e300))[2]
        pull = abs(contact.mu * a)
    return max(force, pull) / contact.mu * _share(body) * SLACK


SLACK = 1.0 + 1e-9
"""The bound on the acceleration is itself computed: a little more keeps it a bound."""
