"""push-only: spring and damper that may only push; see `sim.laws.dashpot`."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from sim.laws.branch import APART_AT_NO_FORCE, Branch, Guard
from sim.laws.contact_law import IsolatedContact, Memory
from sim.laws.damped_oscillation import Swing, first_zero
from sim.laws.dashpot import Dashpot, damping_to_zero_force

if TYPE_CHECKING:
    from sim.laws.stepping import SteppedContact


NO_PUSH = 1e-12
"""Of k d. Spring and damper cancel where the force is zero; what rounding leaves is no force."""


@dataclass(frozen=True, slots=True, eq=False)
class PushOnly(Dashpot):
    """Ends at force zero, damping corrected."""

    recontacts: ClassVar[bool] = True

    def __post_init__(self) -> None:
        object.__setattr__(self, "damping", damping_to_zero_force(self.e))

    @property
    def delivered(self) -> float:
        """The restitution that comes out."""
        return self.e

    def figures(self, mu: float) -> IsolatedContact:
        """Exact e for 0 < e <= 1."""
        w0, d = math.sqrt(self.stiffness / mu), self.damping
        e = self.delivered
        return self.figures_from(mu, 2.0 / (w0 * d.sinc), e, 2.0 * d.zeta * e / w0)

    def stretches(self, mu: float, d0: float, v0: float, memory: Memory) -> tuple[Swing, ...]:
        """Until the force is zero."""
        rate = self.damping.rate(self.stiffness, mu)
        if d0 == 0.0 and v0 > 0.0:  # from first touch the half-angle form is exact at any damping
            return (Swing(rate, 0.0, 2.0 / (rate.w0 * self.damping.sinc), 0.0, d0, v0),)
        n0 = rate.w0 * rate.w0 * d0 + 2.0 * rate.beta * v0  # N/mu solves the same equation
        if abs(n0) <= NO_PUSH * rate.w0 * rate.w0 * d0:
            n0 = 0.0
        n1 = rate.w0 * rate.w0 * v0 - 2.0 * rate.beta * n0
        pulls = n0 < 0.0 or (n0 == 0.0 and n1 <= 0.0)  # it may not: it is over as it begins
        duration = 0.0 if pulls else first_zero(rate, n0, n1)
        return (Swing(rate, 0.0, duration, 0.0, d0, v0),)

    def guards(self, branch: Branch, d: float, memory: Memory) -> tuple[Guard, ...]:
        """It ends where it would pull."""
        return APART_AT_NO_FORCE

    def residual_overlap(self, d: float, memory: Memory) -> float:
        """Whatever is left: nothing without damping, when force and overlap are nought together."""
        return 0.0 if self.e == 1.0 else d

    def stored_under(self, d: float, force: float) -> float:
        """k d²/2 while it pushes."""
        return 0.5 * self.stiffness * d**2 if force > 0.0 else 0.0

    def last_force(self, mu: float, v: float) -> float:
        """It ends where there is none."""
        return 0.0

    def stepping(self, mu: float) -> SteppedContact:
        """Spring and damper while they push."""
        from sim.laws.dashpot_stepping import DashpotForce  # only where a method steps

        return DashpotForce(self.stiffness, self.damper(mu), pulls=False)


make = PushOnly
