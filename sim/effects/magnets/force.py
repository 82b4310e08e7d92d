"""magnets: repelling ends of two neighbouring carts, or of a cart and a wall.

    N = C / r^n        r [m] is the gap between the edges, n is `power`, C [N m^n] `strength`

N pushes the two apart, the same on both. Energy C / ((n − 1) r^(n−1)), for n = 1 −C ln(r / 1 m):
it grows without limit as r falls to nought, so the two never touch, and what they had comes back
whole (e = 1). Between two carts alone with n = 3: r² = r0² + 2 r0 r0' t + (2 E/mu) t².

The Taylor series of r^−n follows from r q' = −n r' q:
    q_j = (1/(j r_0)) sum_i (−n i − (j − i)) r_i q_(j−i).
Source of the law: measured on air tracks, n from 2 to 4; the series is Euler's.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from operator import mul
from typing import ClassVar

from sim.effects.forces import Acting, PairForce, Poly
from sim.effects.where import gap_of
from sim.scene.effects import Effect
from sim.scene.model import Scene

NEAREST = 5e-9
"""Of the longest cart, or, where carts are points, of how far they are apart at first: a nanometre,
about as near as atoms are, of 20 cm. With n = 1 a fast cart would come to 1e-100 m."""


MOST_TERMS = 40
"""Of a series. Tier 2 sums 26."""


@lru_cache(maxsize=64)
def _weights(power: float) -> list[list[float]]:
    """n i + (j − i) for i from 1 to j."""
    return [[power * i + j - i for i in range(1, j + 1)] for j in range(MOST_TERMS)]


class MagnetForce:
    """A power of the gap."""

    kind: ClassVar[str] = "magnets"
    linear: ClassVar[bool] = False

    def __init__(self, strength: float, power: float, nearest: float) -> None:
        self.strength, self.power, self.nearest = strength, power, nearest

    def force(self, gap: float, rate: float) -> float:
        """C / r^n. A trial step of an adaptive method may look nearer than a run may come: what it
        finds there is steep, so that the step is made anew with a smaller one."""
        return float(self.strength * max(gap, self.nearest) ** -self.power)

    def energy(self, gap: float) -> float:
        """C / ((n − 1) r^(n−1)); for n = 1 −C ln r."""
        if self.power == 1.0:
            return -self.strength * math.log(gap)
        return float(self.strength / (self.power - 1.0) * gap ** (1.0 - self.power))

    def bounds(self, gap: float) -> tuple[float, float]:
        """n C / r^(n+1); no damping."""
        return float(self.power * self.strength * gap ** (-self.power - 1.0)), 0.0

    def expansion(self) -> Callable[[int, Poly], float]:
        """Euler's recurrence for a power of a series."""
        strength, power = self.strength, self.power
        q: list[float] = []
        weights = _weights(power)

        def coefficient(n: int, over: Poly) -> float:
            if n == 0:
                q.append(float((-over[0]) ** -power))
            else:
                weighed = map(mul, weights[n], over[1 : n + 1])
                total = sum(map(mul, weighed, q[n - 1 :: -1]))
                q.append(total / (n * -over[0]))
            return strength * q[n]

        return coefficient

    def damping(self) -> float:
        """None."""
        return 0.0


def _size(scene: Scene) -> float:
    """m. Of the longest cart; of points, how far they and the walls are apart."""
    places = [cart.position for cart in scene.carts]
    places += [x for end, x in ((scene.track.left, 0.0), (scene.track.right, scene.track.length))
               if end == "wall" and x is not None]  # fmt: skip
    return max(cart.length for cart in scene.carts) or max(places) - min(places)


class Magnets(Acting):
    """A force across one gap."""

    kind = "magnets"

    def __init__(self, effect: Effect, scene: Scene) -> None:
        self._gap = gap_of(effect, scene)
        strength, power = effect.numbers["strength"], effect.numbers["power"]
        self._force = MagnetForce(strength, power, NEAREST * _size(scene))

    def pair_force(self, gap: int) -> PairForce | None:
        """The magnets, in their gap."""
        return self._force if gap == self._gap else None


act = Magnets
