"""richardson: velocity Verlet in one step and in two halves; their difference tells the error.

    y' = y₂ + (y₂ − y₁)/3        y₁: one step of h, y₂: two of h/2

A step of Verlet errs by c h³, two halves by a quarter of that: the difference is three quarters of
the error, and a third of it more takes the error away. Order 4 where forces depend on places alone,
3 with damping (see `yoshida`). Six evaluations. The combination is not symplectic: the energy of a
spring drifts, as with RK4. Source: L. F. Richardson, Phil. Trans. R. Soc. A 210 (1911) 307.
"""

from __future__ import annotations

from typing import Any, ClassVar

from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.pairs import PerCart
from sim.dynamics.stepping.velocity_verlet import VelocityVerlet

MORE = 1.0 / (2.0**VelocityVerlet.order - 1.0)
"""Of the difference, on top of the finer result."""


class Richardson:
    """Order 4 where forces depend on places alone."""

    name: ClassVar[str] = "richardson"
    order: ClassVar[int] = 4
    weights: ClassVar[tuple[float, ...]] = (
        *(-MORE * weight for weight in VelocityVerlet.weights),
        *(0.5 * (1.0 + MORE) * weight for _ in range(2) for weight in VelocityVerlet.weights),
    )

    @staticmethod
    def step(field: Field, t: Any, s: PerCart, v: PerCart, h: Any) -> tuple[PerCart, PerCart]:
        """One step."""
        half = 0.5 * h
        coarse = VelocityVerlet.step(field, t, s, v, h)
        fine = VelocityVerlet.step(
            field, t + half, *VelocityVerlet.step(field, t, s, v, half), half
        )
        places, speeds = (
            [b + MORE * (b - a) for a, b in zip(one, two, strict=True)]
            for one, two in zip(coarse, fine, strict=True)
        )
        return places, speeds
