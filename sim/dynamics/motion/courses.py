"""One body that nobody touches, under forces of its own: closed forms.

With a = F/m of all constant forces (sliding friction included), γ = b/m and κ = c/m of drag:

    γ = κ = 0    v = v0 + a t                          x = x0 + v0 t + a t²/2
    κ = 0        v = v0 + (a − γ v0) φ(t)              x = x0 + v0 t + (a − γ v0) ψ(t)
                 φ = (1 − e^(−γt))/γ ,  ψ = (t − φ)/γ
    a = γ = 0    v = v0/(1 + κ|v0|t)                   x = x0 ± ln(1 + κ|v0|t)/κ
    else         a tangent or a hyperbolic tangent     (`drag_course`)

Every velocity here is monotone in time and every |acceleration| falls or stays. A body that slides
under friction ends its flight where v = 0. Errors: a few units in the last place.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

from sim.dynamics.state.loads import Load


class Course(Protocol):
    """Motion from x = 0 with v0 at t = 0."""

    @property
    def sparse(self) -> bool:
        """Is x a polynomial of degree 2 at most, so that two samples draw it?"""

    @property
    def law(self) -> tuple[float, float, float]:
        """a [m/s²], γ [1/s], κ [1/m] of v' = a − γ v − κ v|v|."""

    def at(self, t: float) -> tuple[float, float, float]:
        """x [m], v [m/s], a [m/s²]."""

    def halt(self) -> float:
        """s to v = 0; inf if never."""

    def marks(self, end: float) -> list[float]:
        """s. Times between which the curve is equally easy to draw."""


@dataclass(slots=True)
class Parabola:
    """Constant acceleration."""

    v0: float
    a: float
    sparse: bool = True

    @property
    def law(self) -> tuple[float, float, float]:
        """Of v'."""
        return self.a, 0.0, 0.0

    def at(self, t: float) -> tuple[float, float, float]:
        """x, v, a."""
        return (self.v0 + 0.5 * self.a * t) * t, self.v0 + self.a * t, self.a

    def marks(self, end: float) -> list[float]:
        """None: it is a polynomial."""
        return []

    def halt(self) -> float:
        """−v0/a."""
        t = -self.v0 / self.a if self.a != 0.0 else 0.0
        return t if t > 0.0 else math.inf


SMALL = 0.05
"""γt. Below it t − φ is summed as a series: eight terms leave less than 1e-16."""

FADED = 12
"""Time constants after which a flight has faded below 1e-5 of its start."""


@dataclass(frozen=True, slots=True)
class Fading:
    """Constant force and linear drag."""

    v0: float
    a: float
    gamma: float  # 1/s
    sparse: bool = False

    @property
    def law(self) -> tuple[float, float, float]:
        """Of v'."""
        return self.a, self.gamma, 0.0

    def at(self, t: float) -> tuple[float, float, float]:
        """x, v, a."""
        z = self.gamma * t
        start = self.a - self.gamma * self.v0
        phi = -math.expm1(-z) / self.gamma
        if z < SMALL:
            term, total = 0.5, 0.0
            for n in range(3, 11):
                total += term
                term *= -z / n
            psi = total * t * t
        else:
            psi = (t - phi) / self.gamma
        return self.v0 * t + start * psi, self.v0 + start * phi, start * math.exp(-z)

    def marks(self, end: float) -> list[float]:
        """Every time constant, until it has faded."""
        times = int(min(end * self.gamma, FADED))
        return [n / self.gamma for n in range(1, times + 1)]

    def halt(self) -> float:
        """Where φ = −v0/(a − γ v0)."""
        start = self.a - self.gamma * self.v0
        part = self.gamma * self.v0 / start if start != 0.0 else 0.0
        if start == 0.0 or not -1.0 < part < 0.0:
            return math.inf
        return -math.log1p(part) / self.gamma


@dataclass(frozen=True, slots=True)
class Slowing:
    """Quadratic drag alone."""

    v0: float
    kappa: float  # 1/m
    sparse: bool = False

    @property
    def law(self) -> tuple[float, float, float]:
        """Of v'."""
        return 0.0, 0.0, self.kappa

    def at(self, t: float) -> tuple[float, float, float]:
        """x, v, a."""
        pace = self.kappa * abs(self.v0) * t
        v = self.v0 / (1.0 + pace)
        displacement = math.copysign(math.log1p(pace) / self.kappa, self.v0)
        return displacement, v, -self.kappa * v * abs(v)

    def marks(self, end: float) -> list[float]:
        """Whenever the velocity has fallen to a half."""
        pace = self.kappa * abs(self.v0)
        halvings = int(math.log2(1.0 + pace * end)) if pace * end < math.inf else 1000
        return [(2.0**n - 1.0) / pace for n in range(1, halvings + 1)]

    def halt(self) -> float:
        """Never."""
        return math.inf


def course(mass: float, v: float, sliding: int, load: Load) -> Course | None:
    """The closed form for a body that slides in that direction; None if there is none."""
    a = (load.steady - sliding * load.kinetic) / mass
    if load.quadratic == 0.0:
        return Parabola(v, a) if load.linear == 0.0 else Fading(v, a, load.linear / mass)
    if a == 0.0 and load.linear == 0.0:
        return Slowing(v, load.quadratic / mass)
    if load.linear and len({f.kind for f in load.forces if f.linear or f.quadratic}) > 1:
        return None  # whose drag took what, no formula here tells
    from sim.dynamics.motion.drag_course import driven  # where a scene calls for it

    return driven(v, a, load.linear / mass, load.quadratic / mass)
