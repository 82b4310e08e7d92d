"""hertz: two elastic spheres, for the hard cases.

    N = K d^(3/2) + C d^(1/4) d'      until the overlap is zero again

K [N/m^1.5] is the stiffness. The damping C = zeta sqrt(5 K mu) returns the asked-for e exactly, at
every speed: y = d^(5/4) obeys the linear equation of `paper`, zeta = L/sqrt(pi² + L²), L = −ln e.
e = 1 is Hertz's own law. Energy (2/5) K d^(5/2). With the approach speed u and e = 1:

    greatest overlap (5 mu u²/(4 K))^(2/5)      duration 3.21806545972 (mu²/(K² u))^(1/5)

A pair by itself has a closed form up to one integral (`course`); where others push too it has a
power series in a time of its own (`sim.dynamics.motion.curved.own_time`). Sources: Hertz, J. reine
angew. Math. 92 (1882) 156; the mapping: Antypov & Elliott, EPL 94 (2011) 50004.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, ClassVar

from sim.laws.branch import APART_AT_NO_OVERLAP, CURVED, Branch, Guard
from sim.laws.contact_law import IsolatedContact, Memory
from sim.laws.damped_oscillation import Swing
from sim.laws.dashpot import damping_to_zero_overlap

if TYPE_CHECKING:
    from sim.laws.hertz.alone import Alone
    from sim.laws.stepping import SteppedContact


@dataclass(frozen=True, slots=True, eq=False)
class Hertz:
    """Two spheres."""

    linear: ClassVar[bool] = False
    recontacts: ClassVar[bool] = False
    held_below: ClassVar[float] = 0.0
    grows: ClassVar[tuple[float, float]] = (2.5, 1.25)
    stiffness: float  # N/m^1.5
    e: float
    zeta: float = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "zeta", damping_to_zero_overlap(self.e).zeta)

    def damper(self, mu: float) -> float:
        """C in N s/m^1.25."""
        return self.zeta * math.sqrt(5.0 * self.stiffness * mu)

    def force(self, mu: float, d: float, v: float) -> float:
        """N at overlap d [m] and rate v [m/s]; 0 without overlap."""
        if d <= 0.0:
            return 0.0
        root = math.sqrt(d)
        if self.zeta == 0.0:
            return self.stiffness * d * root
        return self.stiffness * d * root + self.damper(mu) * math.sqrt(root) * v

    def of_root(self, mu: float) -> tuple[float, float]:
        """K and C of N = K z^6 + C z d', z = d^(1/4)."""
        return self.stiffness, self.damper(mu) if self.zeta else 0.0

    def dissipated(self, mu: float, d: float, v: float) -> float:
        """W. What the damper takes just now."""
        if d <= 0.0 or self.zeta == 0.0:
            return 0.0
        return self.damper(mu) * math.sqrt(math.sqrt(d)) * v * v

    def figures(self, mu: float) -> IsolatedContact:
        """Not proportional to the speed: ask `alone`. Raises NotImplementedError."""
        raise NotImplementedError

    def stretches(self, mu: float, d0: float, v0: float, memory: Memory) -> tuple[Swing, ...]:
        """No closed form in t: ask `alone`. Raises NotImplementedError."""
        raise NotImplementedError

    def alone(self, mu: float, d: float, v: float) -> Alone | None:
        """The course of a pair that nobody else touches, from overlap d [m] and rate v [m/s]."""
        from sim.laws.hertz.alone import alone  # where a scene calls for it

        return alone(self.stiffness, self.damper(mu), self.e, self.zeta, mu, d, v)

    def resting_overlap(self, memory: Memory) -> float:
        """Nothing is remembered."""
        return 0.0

    def stored(self, d: float, v: float, memory: Memory) -> float:
        """(2/5) K d^(5/2)."""
        return 0.4 * self.stiffness * d * d * math.sqrt(d) if d > 0.0 else 0.0

    def remember(self, d: float, memory: Memory) -> Memory:
        """Nothing."""
        return 0.0

    @property
    def steepest(self) -> float:
        """Its only number."""
        return self.stiffness

    def branch(self, mu: float, d: float, v: float, memory: Memory, *, pressing: bool) -> Branch:
        """None that is linear."""
        return CURVED

    def guards(self, branch: Branch, d: float, memory: Memory) -> tuple[Guard, ...]:
        """It ends at no overlap."""
        return APART_AT_NO_OVERLAP

    def residual_overlap(self, d: float, memory: Memory) -> float:
        """Found by the method that integrates it."""
        return d

    def last_force(self, mu: float, v: float) -> float:
        """None at no overlap."""
        return 0.0

    def stored_under(self, d: float, force: float) -> float:
        """(2/5) K d^(5/2), while its damper pulls too."""
        return 0.4 * self.stiffness * float(d**2.5) if force else 0.0

    def kept(self, branch: Branch, start: float, end: float) -> float:
        """Its damper takes, nothing else."""
        return 0.0

    def stepping(self, mu: float) -> SteppedContact:
        """Its own formula."""
        from sim.laws.hertz.stepping import HertzForce  # only where a method steps

        return HertzForce(self, mu)


make = Hertz
