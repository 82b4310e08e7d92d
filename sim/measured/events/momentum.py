"""Both masses weighed: momentum before and after, and whether they agree.

Here nothing is taken from the third law: p = m_A v_A + m_B v_B on each side, from the balance and
the velocities. The push J = |m Δv| lends its share to friction in the contact, see `quantities`.
"""

from __future__ import annotations

from dataclasses import dataclass

from sim.measured.events.in_step import StepMatch
from sim.measured.events.outcome import HALF, Outcome, spread
from sim.measured.events.quantities import directions, loss
from sim.measured.events.sides import Speeds


@dataclass(frozen=True, slots=True)
class Momentum:
    """kg m/s; each `half` is half of a 95 % interval; `agree` counts friction in the contact."""

    before: float
    before_half: float
    after: float
    after_half: float
    change: float
    change_half: float
    friction: float  # what friction may have taken, at most

    @property
    def agree(self) -> bool:
        """Whether the change is within its interval and what friction may take."""
        return abs(self.change) <= self.change_half + self.friction


def momentum_of(
    speeds: Speeds, masses: tuple[float, float], step: StepMatch, outcome: Outcome
) -> Momentum:
    """`masses`: kg, A and B."""
    a, b = masses
    v = speeds.v
    before, after = a * v[0] + b * v[1], a * v[2] + b * v[3]
    push = 0.5 * (abs(a * (v[2] - v[0])) + abs(b * (v[3] - v[1])))
    friction = loss(speeds.v, step, outcome) * push * sum(map(abs, directions(speeds.v)))
    return Momentum(
        before,
        HALF * spread(speeds, (a, b, 0, 0)),
        after,
        HALF * spread(speeds, (0, 0, a, b)),
        after - before,
        HALF * spread(speeds, (-a, -b, a, b)),
        friction,
    )
