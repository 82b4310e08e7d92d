"""spring: a spring between two neighbouring carts, or a cart and a wall, edge to edge.

    N = k (L − r) − c r'       r [m] is the gap between the edges, L the natural length

N > 0 pushes the two apart, N < 0 pulls them together: the same number on both, opposite in
direction. k [N/m] is `stiffness`, c [N s/m] `damping`. Energy ½ k (r − L)²; the damper takes
c r'² per second, which warms the spring. Alone between two carts it is a harmonic oscillation
with ω = sqrt(k/mu), mu = m1 m2/(m1 + m2). Bumpers still touch when r falls to nought.
Source: Hooke's law.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from sim.effects.forces import Acting, PairForce, Poly
from sim.effects.where import gap_of
from sim.scene.effects import Effect
from sim.scene.model import Scene


class SpringForce:
    """Linear in gap and rate."""

    kind: ClassVar[str] = "spring"
    linear: ClassVar[bool] = True
    nearest: ClassVar[float] = 0.0

    def __init__(self, stiffness: float, length: float, damping: float) -> None:
        self.stiffness, self.length, self._damping = stiffness, length, damping

    def force(self, gap: float, rate: float) -> float:
        """k (L − r) − c r'."""
        return self.stiffness * (self.length - gap) - self._damping * rate

    def energy(self, gap: float) -> float:
        """½ k (r − L)²."""
        return 0.5 * self.stiffness * (gap - self.length) ** 2

    def bounds(self, gap: float) -> tuple[float, float]:
        """k and c."""
        return self.stiffness, self._damping

    def expansion(self) -> Callable[[int, Poly], float]:
        """Linear in the overlap −r."""
        k, c, length = self.stiffness, self._damping, self.length

        def coefficient(n: int, over: Poly) -> float:
            stretched = over[n] + length if n == 0 else over[n]
            return k * stretched + c * (n + 1) * over[n + 1]

        return coefficient

    def damping(self) -> float:
        """c."""
        return self._damping


class Spring(Acting):
    """A force across one gap."""

    kind = "spring"

    def __init__(self, effect: Effect, scene: Scene) -> None:
        numbers = effect.numbers
        self._gap = gap_of(effect, scene)
        self._force = SpringForce(numbers["stiffness"], numbers["length"], numbers["damping"])

    def pair_force(self, gap: int) -> PairForce | None:
        """The spring, in its gap."""
        return self._force if gap == self._gap else None


act = Spring
