"""paper: equation (3) of the paper, mended; see `sim.laws.dashpot`."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from sim.laws.branch import APART_AT_NO_OVERLAP, Branch, Guard
from sim.laws.contact_law import IsolatedContact, Memory
from sim.laws.damped_oscillation import Swing, first_zero
from sim.laws.dashpot import Dashpot, damping_to_zero_overlap

if TYPE_CHECKING:
    from sim.laws.stepping import SteppedContact


@dataclass(frozen=True, slots=True, eq=False)
class Paper(Dashpot):
    """Equation (3), mended: ends at overlap zero."""

    recontacts: ClassVar[bool] = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "damping", damping_to_zero_overlap(self.e))

    def figures(self, mu: float) -> IsolatedContact:
        """Exact e for every e in 0 to 1; e = 0 never separates."""
        w = math.sqrt(self.stiffness / mu) * self.damping.sine
        pull = -2.0 * self.damping.zeta * self.e * math.sqrt(self.stiffness * mu)
        return self.figures_from(mu, math.pi / w if w > 0.0 else math.inf, self.e, 0.0, pull)

    def stretches(self, mu: float, d0: float, v0: float, memory: Memory) -> tuple[Swing, ...]:
        """Until the overlap is zero."""
        rate = self.damping.rate(self.stiffness, mu)
        over = d0 <= 0.0 and v0 <= 0.0  # it has no overlap, and gets none
        duration = 0.0 if over else first_zero(rate, d0, v0)
        return (Swing(rate, 0.0, duration, 0.0, d0, v0),)

    def guards(self, branch: Branch, d: float, memory: Memory) -> tuple[Guard, ...]:
        """It may pull: it ends at no overlap."""
        return APART_AT_NO_OVERLAP

    def residual_overlap(self, d: float, memory: Memory) -> float:
        """None."""
        return 0.0

    def last_force(self, mu: float, v: float) -> float:
        """The damper pulls."""
        return self.force(mu, 0.0, v)

    def stepping(self, mu: float) -> SteppedContact:
        """Spring and damper while they overlap."""
        from sim.laws.dashpot_stepping import DashpotForce  # only where a method steps

        return DashpotForce(self.stiffness, self.damper(mu), pulls=True)


make = Paper
