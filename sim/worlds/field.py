"""The forces of a scene with what a world adds to them, booked under the world's name.

    on A   −N       and from nowhere   −(α − 1) N, or N(t) − α N(t − delay) where it comes late
    on B   +N       and from nowhere   +(β − 1) N
    on each cart                       −(m/τ) v

N [N] is what pushes the two apart by the scene's own law: a contact, or magnets; what pulls is as
in ours. So momentum and energy close, and the entry of that name is what no body gave.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from typing import Any

from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.pairs import Pair, Row
from sim.scene.model import Scene
from sim.worlds.force import EVEN, Impossible, Two


class WorldField(Field):
    """A field in which what is done is not what is suffered."""

    def __init__(self, scene: Scene, name: str, world: Impossible) -> None:
        super().__init__(scene)
        self.name, self.world = name, world
        self.resistance = [world.resistance(mass) for mass in self.mass]
        self.shares: dict[int, Two] = {}  # of the gaps that touch
        self.hits: dict[int, int] = {}  # by gap: which of the two is faster, 0 or 1
        self.past: dict[int, tuple[list[float], list[float]]] = {}  # s and N, by gap
        self.last_push = -math.inf  # s
        self.nowhere: Row = [0.0] * self.count  # N on each cart
        self.on: dict[tuple[int, int], float] = {}  # N on side 0 or 1 of a gap, pushing apart

    def _total(self, t: Any, v: Row, push: Row, links: dict[tuple[str, int], float]) -> Row:
        total = super()._total(t, v, push, links)
        extra = [-b * u for b, u in zip(self.resistance, v, strict=True)]
        for pair in self.pairs:
            pushed = _apart(pair.gap, push, links)
            pulled = sum(f for (_, gap), f in links.items() if gap == pair.gap and f < 0.0)
            for side, (cart, size) in enumerate(self._sides(pair, t, v, pushed)):
                self.on[pair.gap, side] = size + pulled
                if cart is not None:
                    extra[cart] += (pushed - size) if side == 0 else (size - pushed)
        self.nowhere = extra
        return [a + b for a, b in zip(total, extra, strict=True)]

    def _sides(self, pair: Pair, t: float, v: Row, pushed: float) -> list[tuple[int | None, float]]:
        """Cart and push [N] on each of the two."""
        alpha, beta = self._shares(pair, v, pushed)
        on = [alpha * pushed, beta * pushed]
        if self.world.delay and pair.left is not None and pair.right is not None:
            on[self.hits.get(pair.gap, 0)] = self.earlier(pair.gap, t - self.world.delay)
        return [(pair.left, on[0]), (pair.right, on[1])]

    def _shares(self, pair: Pair, v: Row, pushed: float) -> Two:
        """Chosen when the two begin to push each other, and kept until they stop."""
        gap = pair.gap
        if pushed == 0.0:
            self.shares.pop(gap, None)
            return EVEN
        a, b = pair.left, pair.right
        if a is None or b is None:  # a wall has no mass that could be compared
            return EVEN
        if gap not in self.shares:
            speeds = (float(v[a]), float(v[b]))
            outside = (self._acting_on(a, v), self._acting_on(b, v))
            self.shares[gap] = self.world.shares((self.mass[a], self.mass[b]), speeds, outside)
            self.hits[gap] = 0 if abs(speeds[0]) >= abs(speeds[1]) else 1
        return self.shares[gap]

    def _acting_on(self, cart: int, v: Row) -> float:
        forces = self.body_forces(self.force_time or 0.0)[cart]
        return float(sum(one.at(v[cart]) for one in forces))

    def remember(self, t: float, push: Row, links: dict[tuple[str, int], float]) -> None:
        """A step ended at t with these forces: what comes later is looked up here."""
        for pair in self.pairs:
            size = _apart(pair.gap, push, links)
            times, sizes = self.past.setdefault(pair.gap, ([], []))
            times.append(t)
            sizes.append(float(size))
            if size:
                self.last_push = t

    def earlier(self, gap: int, t: float) -> float:
        """N at t, along straight lines between the ends of steps; 0 before the run."""
        times, sizes = self.past.get(gap, ([], []))
        k = bisect_right(times, t)
        if k == 0:
            return 0.0
        if k == len(times):
            return sizes[-1]
        a, b = times[k - 1], times[k]
        return sizes[k - 1] + (sizes[k] - sizes[k - 1]) * (t - a) / (b - a)

    def echoes(self, t: float) -> bool:
        """Does a push of the last moments still have to come?"""
        return t <= self.last_push + self.world.delay

    def _outside(self, t: float, v: Row) -> dict[tuple[str, int], float]:
        return super()._outside(t, v) | {(self.name, k): f for k, f in enumerate(self.nowhere)}


def _apart(gap: int, push: Row, links: dict[tuple[str, int], float]) -> Any:
    """N. What pushes the two of a gap apart by the scene's own laws."""
    return push[gap] + sum(f for (_, place), f in links.items() if place == gap and f > 0.0)
