"""When do two neighbours touch whose motions are parabolas: flights, bodies at rest?"""

from __future__ import annotations

import math

from sim.dynamics.motion.coupled_group import CoupledGroup
from sim.dynamics.motion.power_series.series import is_rounding
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.clock import Time, later


def first_fall(room: float, rate: float, a: float) -> float:
    """First t > 0 (or 0) at which room + rate t + a t²/2, room >= 0, falls to zero; inf if never.

    The form of the root is chosen so that nothing cancels: 4e-17 relative at a = 1e-12.
    """
    if room == 0.0 and (rate < 0.0 or (rate == 0.0 and a < 0.0)):
        return 0.0
    square = rate * rate - 2.0 * a * room
    if square < 0.0:
        return math.inf
    root = math.sqrt(square)
    if rate < 0.0:
        return 2.0 * room / (root - rate)
    return (rate + root) / -a if a < 0.0 else math.inf


def with_memory(gap: Gap, now: Time, rest: float, a: float, horizon: float) -> float:
    """Seconds to the touch of a bumper that has not cleared; inf: none up to the horizon [s].

    It is pressed again at its resting overlap, `rest` m, unless it clears first; then it touches at
    no overlap, as a new one does. `a` [m/s²]: of the room between the two.
    """
    again = first_fall(max(gap.room + rest, 0.0), gap.rate, a)
    clear = first_fall(-gap.room, -gap.rate, -a)
    if again <= clear:
        return again if again <= horizon else math.inf
    if clear > horizon:
        return math.inf
    gap.clear_at = later(now, clear)
    found = clear + first_fall(0.0, gap.rate + a * clear, a)
    return found if found <= horizon else math.inf


def is_parabola(body: Body) -> bool:
    """Does it fly freely or under a constant force, or rest?"""
    motion = body.motion
    if isinstance(motion, CoupledGroup):
        return motion.step.rests
    return motion is None or motion.parabolic


def relative(gap: Gap) -> float:
    """m/s². Of two on parabolas."""
    own = _steady(gap.right)
    difference = own - _steady(gap.left)
    return 0.0 if is_rounding(difference, own) else difference


def _steady(body: Body) -> float:
    motion = body.motion
    return 0.0 if motion is None else motion.state(motion.side(body), 0.0)[2]
