"""verlet: velocity Verlet. Position with the old force, velocity with the mean of both.

    a = a(s, v)      s' = s + h v + ½ h² a      v' = v + ½ h (a + a(s', v + h a))

Order 2, two evaluations per step: the force at the end depends on a velocity, which is foretold as
v + h a, and a bumper or an impact may change between steps, so the last force cannot be kept.
Symplectic without damping; stable for ω h < 2. Source: L. Verlet, Phys. Rev. 159 (1967) 98;
Swope et al., J. Chem. Phys. 76 (1982) 637.
"""

from __future__ import annotations

from typing import Any, ClassVar

from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.pairs import PerCart


class VelocityVerlet:
    """Order 2."""

    name: ClassVar[str] = "verlet"
    order: ClassVar[int] = 2
    weights: ClassVar[tuple[float, ...]] = (0.5, 0.5)

    @staticmethod
    def step(field: Field, t: Any, s: PerCart, v: PerCart, h: Any) -> tuple[PerCart, PerCart]:
        """One step."""
        half = 0.5 * h
        a = field.accelerations(t, s, v, h)
        s = [x + h * (speed + half * c) for x, speed, c in zip(s, v, a, strict=True)]
        foretold = [speed + h * c for speed, c in zip(v, a, strict=True)]
        b = field.accelerations(t + h, s, foretold, h)
        return s, [speed + half * (c + d) for speed, c, d in zip(v, a, b, strict=True)]
