"""Effects whose force on a cart is constant for a time: what a proof without integration needs.

    slope      m g sin θ                      friction   μ m g cos θ, θ of the slope under the cart
    push       its force, from ≤ t < until

An effect says so in `constant.py` of its folder, with a function `constant(effect)`.
"""

from __future__ import annotations

from dataclasses import dataclass

from sim.effects.part import part_of
from sim.scene.effects import Effect


@dataclass(frozen=True, slots=True, kw_only=True)
class Constant:
    """On each of the effect's carts. `angle` rad, + up to the right; `friction` kinetic and static
    coefficients; `push` from s, until s, N."""

    angle: float | None = None
    friction: tuple[float, float] | None = None
    push: tuple[float, float, float] | None = None


def constant_of(effect: Effect) -> Constant | None:
    """What is constant in it; None for an effect whose force changes with motion or place."""
    module = part_of(effect.kind, "constant")
    found: Constant | None = module.constant(effect) if module else None
    return found
