"""When do two neighbours touch next? Detection moves nothing.

Two free neighbours: room / closing speed, one division. Two on parabolas: a quadratic, solved so
that nothing cancels. Otherwise their motions are formulas with bounded acceleration, and the first
zero of the room is found by steps that cannot jump over it (`safe_step`).
"""

from __future__ import annotations

import math
from functools import partial

from sim.dynamics.loop import alike, parabolas, recontact
from sim.dynamics.loop.rooms import SAME_SPEED, clearance, no_approach, rate_at, resting, room_at
from sim.dynamics.motion.linear_pair import LinearPair
from sim.dynamics.motion.pair_contact import PairContact
from sim.dynamics.motion.safe_step import SAFE_STEPS
from sim.dynamics.state import flips
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.clock import Time, elapsed, later
from sim.laws.contact_law import ContactLaw
from sim.laws.rounding import LAST_BIT

TOUCH_ROUNDING = 1e-15
"""Relative to the search's span. A room that would close within this time has closed."""

PROBES = tuple(10.0 ** (-0.5 * n) for n in range(12, -1, -1))
"""Of the horizon, ever later. Neighbours that touch without closing: the first sign of their room
that is known tells whether the one is being pushed into the other, or away."""

KNOWN = 1e-15
"""Of how far the faster one goes up to the horizon, and of the swing that a formula tells its
place from. Less room than that has no sign."""

CLEARLY = 1e4
"""Times that. From so much room on the search for the next touch is not led astray by rounding."""


def next_touch(gap: Gap, own_separation: bool = False) -> float:
    """Seconds from now to the touch of two free neighbours; inf if there is none in sight."""
    law = gap.law
    gap.clear_at = None  # what was foreseen while one of them moved otherwise
    if gap.rate < 0.0:
        room = gap.room
        if room < 0.0:
            room += resting(gap)
        still_pressed = gap.room < 0.0 and law is not None and law.recontacts
        if room <= 0.0 and law is not None and not still_pressed and _is_last_bit(gap):
            return math.inf
        return max(0.0, room / -gap.rate)
    parted = own_separation or gap.spent
    if gap.room < 0.0 and law is not None and law.recontacts and not parted:
        return 0.0 if recontact.pushes(law, gap.mu, gap.room, gap.rate) else math.inf
    return math.inf


def _is_last_bit(gap: Gap) -> bool:
    """Two that touch, free of all forces, and close with no more than the last bit of a velocity
    have parted: one more contact would give it to the next neighbour, and so on for ever."""
    return -gap.rate <= LAST_BIT * max(abs(gap.left.v), abs(gap.right.v))


def touch_in_motion(gap: Gap, now: Time, end: Time, own_separation: bool = False) -> float:
    """Seconds from `now` to a touch while a body of `gap` is not in free flight; inf if none.

    Looks no further than the end of the first of those motions, or of the run: then the gap is
    asked again. Notes in the gap when an overlap clears on the way.
    """
    left, right = gap.left.motion, gap.right.motion
    horizon = min(motion.time_left(now) for motion in (left, right) if motion is not None)
    horizon = min(horizon, elapsed(now, end))
    gap.clear_at = None
    if gap.room < 0.0 and gap.law is not None and (gap.law.recontacts or gap.spent):
        return _pushed_again(gap, gap.law, now, horizon, own_separation)
    rest = resting(gap)
    both = parabolas.is_parabola(gap.left) and parabolas.is_parabola(gap.right)
    relative = parabolas.relative(gap) if both else 0.0
    if both and rest > 0.0 and not no_approach(gap, now):
        return parabolas.with_memory(gap, now, rest, relative, horizon)
    if both and rest == 0.0:
        found = parabolas.first_fall(max(gap.room, 0.0), gap.rate, relative)
        return found if found <= horizon else math.inf
    fastest = _speeds(gap.left, now, horizon)[1]
    slowest = _speeds(gap.right, now, horizon)[0]
    if gap.room + rest > max(0.0, fastest - slowest) * horizon and rest == 0.0:
        return math.inf
    if rest > 0.0:
        return _touch_with_memory(gap, now, rest, horizon)
    return _touch_from(gap, now, gap.room, rest, horizon)


def _touch_from(gap: Gap, now: Time, room: float, rest: float, horizon: float) -> float:
    """The first touch from now on, at room = −rest; it may be at once."""
    begin = 0.0
    if room + rest <= 0.0:
        level = no_approach(gap, now) or -SAME_SPEED * _fastest(gap, now, horizon) <= gap.rate <= 0
        if gap.rate < 0.0 and not level:
            return 0.0
        if level:
            begin = _open_from(gap, now, rest, horizon)
            if begin == 0.0 and gap.law is None:
                return alike.pressed_from(gap, now, [probe * horizon for probe in PROBES])
            if begin in (0.0, math.inf):
                return begin
    found = _first_fall(gap, now, begin, horizon, rest, +1.0)
    return math.inf if found is None else found


def _open_from(gap: Gap, now: Time, rest: float, horizon: float) -> float:
    """A time at which the room of two that touch without closing is open; 0: it closes at once.

    inf where its sign is not known up to the horizon. Bumpers that have just touched and parted
    more than once without motion are open as long as it is not known: else they would alternate.
    """
    noise = KNOWN * (_fastest(gap, now, horizon) * horizon + _swing(gap.left) + _swing(gap.right))
    waits = gap.law is not None and flips.margin(gap, now, horizon) > 0.0
    opened = unknown = 0.0
    for probe in PROBES:
        then = clearance(gap, now, probe * horizon, rest)
        if then < -noise:
            return opened or unknown  # 0: it has closed from the beginning
        if waits:
            unknown = probe * horizon
        if then > noise:
            opened = probe * horizon
        if then > CLEARLY * noise:
            return opened
    return opened or math.inf


def _fastest(gap: Gap, now: Time, horizon: float) -> float:
    """m/s. No faster will either of the two be up to the horizon."""
    return max(abs(v) for body in (gap.left, gap.right) for v in _speeds(body, now, horizon))


def _swing(body: Body) -> float:
    """m. The lengths whose difference a closed form of a pair tells as where the body went."""
    motion = body.motion
    if isinstance(motion, PairContact):
        return abs(motion.side(body)) * motion.greatest_overlap()
    if not isinstance(motion, LinearPair):
        return 0.0
    between = motion.between
    return abs(motion.side(body)) * (abs(between.o0) + abs(between.centre))


def _touch_with_memory(gap: Gap, now: Time, rest: float, horizon: float) -> float:
    """A bumper that has not cleared is pressed again at its resting overlap, or clears first."""
    again = _touch_from(gap, now, gap.room, rest, horizon)
    return again if again == 0.0 else _unless_it_clears(gap, now, 0.0, again, horizon)


def _unless_it_clears(gap: Gap, now: Time, t: float, again: float, horizon: float) -> float:
    """The touch at `again`, or, where it clears between t and that, the next at no overlap.

    For once it has cleared it touches as a new one does.
    """
    clear = _first_fall(gap, now, t, min(again, horizon), 0.0, -1.0)
    if clear is None:
        return again
    gap.clear_at = later(now, clear)
    found = _first_fall(gap, now, clear, horizon, 0.0, +1.0)
    return math.inf if found is None else found


def _speeds(body: Body, now: Time, horizon: float) -> tuple[float, float]:
    if body.motion is None:
        return body.v, body.v
    return body.motion.speeds(body, now, horizon)


def _first_fall(
    gap: Gap, now: Time, t: float, horizon: float, rest: float, sign: float
) -> float | None:
    """The first t at which sign × (room + rest) falls to zero, from a t at which it is positive."""
    if sign * gap.rate > 0.0 and alike.by_one_law(gap) is not None:
        return None
    begin = t
    for _ in range(SAFE_STEPS):
        here = sign * clearance(gap, now, t, rest)
        rate = sign * rate_at(gap, now, t)
        if here <= 0.0 and t > begin and rate <= 0.0:  # what grows has fallen by rounding alone
            return t
        step = alike.safe(gap, later(now, t), max(here, 0.0), rate, horizon - t)
        if step <= TOUCH_ROUNDING * t:
            return t if rate < 0.0 else None
        t += step
        if t > horizon:
            return None
    return t


def _pushed_again(
    gap: Gap, law: ContactLaw, now: Time, horizon: float, own_separation: bool
) -> float:
    """A pair that still overlaps, until it clears: by a law that may push again, or let go."""
    rest = law.resting_overlap(gap.memory)
    pushing = recontact.is_pressed if gap.spent else partial(recontact.pushes, law, gap.mu)
    if own_separation is False and pushing(gap.room + rest, gap.rate):
        return 0.0

    def place(t: float) -> tuple[float, float]:
        return room_at(gap, now, t) + rest, rate_at(gap, now, t)

    swing = math.sqrt(gap.mu / law.stiffness)
    t, cleared = recontact.scan(pushing, swing, place, horizon)
    if not cleared:
        return t
    found = _first_fall(gap, now, t, horizon, rest, +1.0)
    again = math.inf if found is None else found
    return again if rest == 0.0 else _unless_it_clears(gap, now, t, again, horizon)
