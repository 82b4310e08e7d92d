"""Two that move side by side: how far can their accelerations differ?

What each of them does says little of their room where both go downhill together: the bound of a
safe step (`safe_step`) is one on the difference of two accelerations, not on their sum.

Each lies, on a stretch, between bounds of its own: their difference between those of the bounds,
and the shorter the stretch, the less it is. A room that closes is asked for as far as it would at
twice the time that it needs at its speed; one that opens on ever longer stretches.

The same law of motion, v' = f(v), as of carts of one mass on one slope in air: two solutions of one
equation do not cross. Who is faster stays faster, and two that open never touch. Drag grows with
the speed, so (v − u)' = f'(w) (v − u) with −L <= f' <= 0: they come together no faster than they
do now, and |v' − u'| <= L |v − u|.

Two that touch, move alike, and open by less than any place is known before they close (carts of two
masses that air parts as they roll uphill, up to where they turn) are pressed from where the
difference of their accelerations turns: earlier a contact without a duration would have to pull,
and end at once.
"""

from __future__ import annotations

from sim.dynamics.motion.flight import Flight
from sim.dynamics.motion.safe_step import safe_step
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.clock import Time, later

LONGER = 8.0
"""Times the step that is known to be safe: the stretch tried next. A longer one has a greater
bound, a shorter one gains little."""

KNOWN = 1e-13
"""Of both accelerations. A smaller difference of theirs has no sign."""

HALVINGS = 60
"""Of a stretch of time: down to its last bit."""


def by_one_law(gap: Gap) -> tuple[float, float, float] | None:
    """a, γ, κ of the law v' = f(v) under which both neighbours fly; None where they do not."""
    left, right = gap.left.motion, gap.right.motion
    if not isinstance(left, Flight) or not isinstance(right, Flight):
        return None
    return left.course.law if left.course.law == right.course.law else None


def safe(gap: Gap, moment: Time, here: float, rate: float, horizon: float) -> float:
    """s from `moment` in which a room of `here` [m] >= 0, growing at `rate`, cannot fall to zero.

    inf where it never can; it is asked for no longer than `horizon` [s].
    """
    stretch = min(horizon, 2.0 * here / -rate) if rate < 0.0 else horizon
    step = safe_step(here, rate, _relative(gap, moment, rate, stretch))
    if step >= stretch:
        return step if stretch == horizon else stretch
    while rate >= 0.0 and step > 0.0:
        stretch = min(LONGER * step, horizon)
        longer = safe_step(here, rate, _relative(gap, moment, rate, stretch))
        if longer < stretch:
            return max(step, longer)
        if stretch == horizon:
            return longer
        step = stretch
    return step


def _relative(gap: Gap, moment: Time, rate: float, stretch: float) -> float:
    """m/s². A bound on the acceleration of the right one relative to the left, for so long [s]."""
    left, right = gap.left, gap.right
    if (law := by_one_law(gap)) is not None:
        _, gamma, kappa = law
        if kappa == 0.0:
            return gamma * abs(rate)
        ends = (*_speeds(left, moment, stretch), *_speeds(right, moment, stretch))
        return (gamma + 2.0 * kappa * max(map(abs, ends))) * abs(rate)
    low_left, high_left = _accelerations(left, moment, stretch)
    low_right, high_right = _accelerations(right, moment, stretch)
    return max(abs(high_right - low_left), abs(low_right - high_left))


def _speeds(body: Body, moment: Time, stretch: float) -> tuple[float, float]:
    return body.motion.speeds(body, moment, stretch) if body.motion else (0.0, 0.0)


def _accelerations(body: Body, moment: Time, stretch: float) -> tuple[float, float]:
    if body.motion is None:
        return 0.0, 0.0
    return body.motion.accelerations(body, moment, stretch)


def pressed_from(gap: Gap, now: Time, probes: list[float]) -> float:
    """s from `now` to where the two are known to be pressed together; 0 where it is not known that
    they open now. `probes` [s]: ever later times."""
    if _pressed(gap, now) >= 0:
        return 0.0
    early = 0.0
    for late in probes:
        if _pressed(gap, later(now, late)) > 0:
            break
        early = late
    else:
        return 0.0
    for _ in range(HALVINGS):
        middle = 0.5 * (early + late)
        if _pressed(gap, later(now, middle)) > 0:
            late = middle
        else:
            early = middle
    return late


def _pressed(gap: Gap, moment: Time) -> int:
    """1 where accelerations press the two together, −1 where they part them, 0: not known."""
    low_left, high_left = _accelerations(gap.left, moment, 0.0)
    low_right, high_right = _accelerations(gap.right, moment, 0.0)
    known = KNOWN * (max(high_left, -low_left) + max(high_right, -low_right))
    return (low_left - high_right > known) - (low_right - high_left > known)
