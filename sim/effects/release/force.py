"""release: an exploder between two touching carts sets free exactly this energy E.

Without a stiffness at one instant:

    ½ mu w'² = ½ mu w² + E        w, w' [m/s]: speed of separation before and after
    impulse = mu (w' − w)         on each, outwards; mu = m1 m2 / (m1 + m2)

With a stiffness k [N/m] by a spring, squeezed to no length between the bumpers until it is let go:

    N = k (L − r)  while r < L, then it falls off        L = sqrt(2 E/k), its natural length [m]

r [m] is the room that it has made: the spring holds ½ k L² = E, and it has no mass. Alone between
two carts from rest N = k L cos(w t) for a quarter of an oscillation, π/(2 w), w = sqrt(k/mu).

Either way, from rest: v1 = −sqrt(2 E mu)/m1, v2 = +sqrt(2 E mu)/m2, equal and opposite momenta.
The two must touch at that time. A pair that touches at the start with equal velocities is held
together until then (the exploder's latch). At one instant what bumpers are squeezed by gives no
energy of its own; a spring acts beside them. Source: conservation of momentum and energy; Hooke.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import ClassVar

from sim.effects.forces import Acting, EnergyRelease, Poly
from sim.effects.where import gap_of
from sim.scene.effects import Effect
from sim.scene.model import Scene


class LooseSpring:
    """Linear in the gap up to `reach` [m], nothing beyond."""

    kind: ClassVar[str] = "release"
    linear: ClassVar[bool] = True
    nearest: ClassVar[float] = 0.0

    def __init__(self, stiffness: float, length: float, start: float = 0.0) -> None:
        self.stiffness, self.length = stiffness, length
        self.reach, self.strongest = start + length, stiffness * length

    def placed(self, gap: float) -> LooseSpring:
        """Let go at this gap: no rounding, and no squeezed bumper, takes of its energy."""
        return LooseSpring(self.stiffness, self.length, gap)

    def force(self, gap: float, rate: float) -> float:
        """k (L − r)."""
        return self.stiffness * max(self.reach - gap, 0.0)

    def energy(self, gap: float) -> float:
        """½ k (L − r)²."""
        return 0.5 * self.stiffness * max(self.reach - gap, 0.0) ** 2

    def bounds(self, gap: float) -> tuple[float, float]:
        """k; no damping."""
        return self.stiffness, 0.0

    def expansion(self) -> Callable[[int, Poly], float]:
        """Linear in the overlap −r."""
        k, reach = self.stiffness, self.reach

        def coefficient(n: int, over: Poly) -> float:
            return k * (over[n] + reach if n == 0 else over[n])

        return coefficient

    def damping(self) -> float:
        """None."""
        return 0.0

    def impulse(self, time: float, summed: float) -> float:
        """k (L t − ∫r dt)."""
        return self.stiffness * (self.reach * time + summed)


class Release(Acting):
    """One release."""

    kind = "release"

    def __init__(self, effect: Effect, scene: Scene) -> None:
        energy, k = effect.numbers["energy"], effect.numbers.get("stiffness")
        spring = None if k is None else LooseSpring(k, math.sqrt(2.0 * energy / k))
        self._one = EnergyRelease(
            self.kind, gap_of(effect, scene), energy, effect.numbers["at"], spring, effect.index
        )

    def releases(self) -> tuple[EnergyRelease, ...]:
        """The energy, the pair and the time."""
        return (self._one,)


act = Release
