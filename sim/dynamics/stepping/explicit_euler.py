"""euler: position with the old velocity, velocity with the old force.

    s' = s + h v      v' = v + h a(s, v)

Order 1, one evaluation per step. A spring without damping gains energy at any step, by the factor
1 + (ω h)² each; with damping ratio ζ the method is stable for h < 2 ζ/ω only.
Source: L. Euler, Institutiones calculi integralis I (1768).
"""

from __future__ import annotations

from typing import Any, ClassVar

from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.pairs import PerCart


class ExplicitEuler:
    """Order 1, gains energy."""

    name: ClassVar[str] = "euler"
    order: ClassVar[int] = 1
    weights: ClassVar[tuple[float, ...]] = (1.0,)

    @staticmethod
    def step(field: Field, t: Any, s: PerCart, v: PerCart, h: Any) -> tuple[PerCart, PerCart]:
        """One step."""
        a = field.accelerations(t, s, v, h)
        return (
            [x + h * speed for x, speed in zip(s, v, strict=True)],
            [speed + h * c for speed, c in zip(v, a, strict=True)],
        )
