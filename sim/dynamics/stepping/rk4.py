"""rk4: the classical Runge-Kutta method, four evaluations per step.

    k1 … k4 at the beginning, twice in the middle, at the end
    y' = y + h (k1 + 2 k2 + 2 k3 + k4)/6

Order 4 where the force is smooth. Where it jumps inside a step, or its slope does, it is of order
1 or 2, whatever the step. Stable for ω h < 2.83 without damping; a spring's energy fades slowly.
Source: W. Kutta, Z. Math. Phys. 46 (1901) 435.
"""

from __future__ import annotations

from typing import Any, ClassVar

from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.pairs import PerCart


class RK4:
    """Order 4 between touches."""

    name: ClassVar[str] = "rk4"
    order: ClassVar[int] = 4
    weights: ClassVar[tuple[float, ...]] = (1 / 6, 1 / 3, 1 / 3, 1 / 6)

    @staticmethod
    def step(field: Field, t: Any, s: PerCart, v: PerCart, h: Any) -> tuple[PerCart, PerCart]:
        """One step."""
        half, sixth = 0.5 * h, h / 6.0
        a = field.accelerations(t, s, v, h)
        v2 = [u + half * c for u, c in zip(v, a, strict=True)]
        b = field.accelerations(t + half, [x + half * u for x, u in zip(s, v, strict=True)], v2, h)
        v3 = [u + half * c for u, c in zip(v, b, strict=True)]
        c3 = field.accelerations(
            t + half, [x + half * u for x, u in zip(s, v2, strict=True)], v3, h
        )
        v4 = [u + h * c for u, c in zip(v, c3, strict=True)]
        d = field.accelerations(t + h, [x + h * u for x, u in zip(s, v3, strict=True)], v4, h)
        return (
            [
                x + sixth * (u1 + 2.0 * (u2 + u3) + u4)
                for x, u1, u2, u3, u4 in zip(s, v, v2, v3, v4, strict=True)
            ],
            [
                u + sixth * (k1 + 2.0 * (k2 + k3) + k4)
                for u, k1, k2, k3, k4 in zip(v, a, b, c3, d, strict=True)
            ],
        )
