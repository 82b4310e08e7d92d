"""semi-implicit: velocity first, then position with the new velocity. What most games do.

    v' = v + h a(s, v)      s' = s + h v'

Order 1, one evaluation per step. Symplectic: a spring's energy wobbles and does not drift.
Stable for ω h < 2. Source: R. de Vogelaere (1956, unpublished report); Hairer, Lubich & Wanner,
Geometric Numerical Integration, I.1.
"""

from __future__ import annotations

from typing import Any, ClassVar

from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.pairs import PerCart


class SemiImplicitEuler:
    """Order 1, keeps a spring's energy."""

    name: ClassVar[str] = "semi-implicit"
    order: ClassVar[int] = 1
    weights: ClassVar[tuple[float, ...]] = (1.0,)

    @staticmethod
    def step(field: Field, t: Any, s: PerCart, v: PerCart, h: Any) -> tuple[PerCart, PerCart]:
        """One step."""
        a = field.accelerations(t, s, v, h)
        v = [speed + h * c for speed, c in zip(v, a, strict=True)]
        return [x + h * speed for x, speed in zip(s, v, strict=True)], v
