"""yoshida: three steps of velocity Verlet, the middle one backwards.

    w1 = 1/(2 − 2^(1/3)),  w0 = 1 − 2 w1 < 0        steps of w1 h, w0 h, w1 h

A step of a method that is its own reverse errs by c h³ + O(h⁵). With w1 + w0 + w1 = 1 the three
come to one step of h, and with w1³ + w0³ + w1³ = 0 what they err by comes to nothing: order 4, and
still symplectic. That holds where forces depend on places alone. Verlet foretells a velocity for
forces that depend on it (damping, drag); it is then not its own reverse, and the order is 3.

Six evaluations; it pays for smooth forces over long times. Stable for ω h < 1.57 only. Sources:
E. Forest and R. D. Ruth, Physica D 43 (1990) 105; H. Yoshida, Phys. Lett. A 150 (1990) 262.
"""

from __future__ import annotations

from typing import Any, ClassVar

from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.pairs import PerCart
from sim.dynamics.stepping.velocity_verlet import VelocityVerlet

OUTER = 1.0 / (2.0 - 2.0 ** (1.0 / 3.0))
PARTS = (OUTER, 1.0 - 2.0 * OUTER, OUTER)


class Yoshida:
    """Order 4 where forces depend on places alone."""

    name: ClassVar[str] = "yoshida"
    order: ClassVar[int] = 4
    weights: ClassVar[tuple[float, ...]] = tuple(
        part * weight for part in PARTS for weight in VelocityVerlet.weights
    )

    @staticmethod
    def step(field: Field, t: Any, s: PerCart, v: PerCart, h: Any) -> tuple[PerCart, PerCart]:
        """One step."""
        for part in PARTS:
            s, v = VelocityVerlet.step(field, t, s, v, part * h)
            t = t + part * h
        return s, v
