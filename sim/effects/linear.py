"""Effects whose force is linear in place and velocity: what a proof by a power series needs.

    spring    k (L − r) − c r′, r the gap between the edges        drag    −b v, of each cart
    release   the same until r = L, from its time on; without a spring all of E at one instant

An effect says so in `linear.py` of its folder, with a function `linear(effect)`; None where its
numbers make it another one.
"""

from __future__ import annotations

from dataclasses import dataclass

from sim.effects.part import part_of
from sim.scene.effects import Effect


@dataclass(frozen=True, slots=True, kw_only=True)
class Linear:
    """`spring`: N/m, natural length in m, N s/m; `drag`: kg/s; `release`: J, s, N/m or None."""

    spring: tuple[float, float, float] | None = None
    drag: float | None = None
    release: tuple[float, float, float | None] | None = None


def linear_of(effect: Effect) -> Linear | None:
    """What is linear in it; None for an effect whose force is not."""
    module = part_of(effect.kind, "linear")
    found: Linear | None = module.linear(effect) if module else None
    return found
