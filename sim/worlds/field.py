"""The forces of a scene with what a world adds to them, booked under the world's name.

    on A   −N       and from nowhere   −(α − 1) N, or N(t) − α N(t − delay) where it comes late
    on B   +N       and from nowhere   +(β − 1) N
    on each cart                       −(m/τ) v

N [N] is what pushes the two apart by the scene's own law: a contact, magnets, a pressed spring.
What pulls is as in ours. So momentum and energy close, and the entry of that name is what no body
gave.

α, β and who runs into whom are chosen where a push begins, and kept until it is over. Trial steps
look past both, so the choice is made between steps (`meet`); and what is still to come of a push is
kept for the side that it is owed to, whoever runs into whom meanwhile. Where N jumps, as it does
where paper touches, two values stand at one instant, that before and that after.
"""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from typing import Any

from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.pairs import Pair, PerCart, link_force
from sim.scene.model import Scene
from sim.worlds.force import EVEN, Impossible, Two

Begun = tuple[Two, int]
"""Factors of a push on the left and on the right, and which of the two ran into the other."""

NO_PUSH: Begun = (EVEN, 0)

Past = tuple[list[float], list[float]]
"""When it comes [s], and N then."""


class WorldField(Field):
    """A field in which what is done is not what is suffered."""

    def __init__(self, scene: Scene, name: str, world: Impossible) -> None:
        super().__init__(scene)
        self.name, self.world = name, world
        self.resistance = [world.resistance(mass) for mass in self.mass]
        self.couples = [pair for pair in self.pairs if None not in (pair.left, pair.right)]
        self.begun: dict[int, Begun] = {}  # by gap, while the two push each other
        self.past: dict[tuple[int, int], Past] = {}  # by gap and the side that gets it later
        self.last_push = -math.inf  # s
        self.nowhere: PerCart = [0.0] * self.count  # N on each cart
        self.on: dict[tuple[int, int], float] = {}  # N on side 0 or 1 of a gap, pushing apart

    def _total(
        self, t: Any, v: PerCart, push: PerCart, links: dict[tuple[str, int], float]
    ) -> PerCart:
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

    def _sides(
        self, pair: Pair, t: float, v: PerCart, pushed: float
    ) -> list[tuple[int | None, float]]:
        """Cart and push [N] on each of the two."""
        gap, two = pair.gap, pair.left is not None and pair.right is not None
        (alpha, beta), hits = self._begun(pair, t, v) if two and pushed else NO_PUSH
        on = [alpha * pushed, beta * pushed]
        if self.world.delay and two:
            on[hits] = 0.0
            for side in (0, 1):
                on[side] += self.earlier(gap, side, t)
        return [(pair.left, on[0]), (pair.right, on[1])]

    def _begun(self, pair: Pair, t: float, v: PerCart) -> Begun:
        """As it was chosen; in the step in which a push begins, as it would be just now."""
        return self.begun.get(pair.gap) or self._chosen(pair, t, v)

    def _chosen(self, pair: Pair, t: float, v: PerCart) -> Begun:
        a, b = pair.left, pair.right
        assert a is not None and b is not None  # a wall has no mass that could be compared
        speeds = (float(v[a]), float(v[b]))
        outside = (self._acting_on(a, t, v), self._acting_on(b, t, v))
        shares = self.world.shares((self.mass[a], self.mass[b]), speeds, outside)
        return shares, 0 if abs(speeds[0]) >= abs(speeds[1]) else 1

    def _acting_on(self, cart: int, t: float, v: PerCart) -> float:
        return float(sum(one.at(v[cart]) for one in self.body_forces(t)[cart]))

    def meet(self, t: float, s: PerCart, v: PerCart) -> None:
        """Between two steps: which pushes begin just now, and which are over."""
        for pair in self.couples:
            if not self._pushes(pair, s, v):
                self.begun.pop(pair.gap, None)
            elif pair.gap not in self.begun:
                self.begun[pair.gap] = self._chosen(pair, t, v)

    def _pushes(self, pair: Pair, s: PerCart, v: PerCart) -> bool:
        if (self.modes or {}).get(pair.gap, "apart") != "apart":
            return True
        if not pair.links or pair.gap in self.joined:
            return False
        d, rate = self.overlap(pair, s, v)
        return any(link_force(link, d, rate, lanes=False) > 0.0 for link in pair.links)

    def remember(self, t: float, s: PerCart, v: PerCart) -> list[float]:
        """What comes later of the pushes at t, the end of a step; when those come that have jumped.

        Said again after what happens at t: then they may have.
        """
        push, links, _ = self.forces(t, s, v)
        due, jumps = t + self.world.delay, []
        for pair in self.couples:
            size = float(_apart(pair.gap, push, links))
            if size:
                self.last_push = t
            for side in (0, 1):
                times, sizes = self.past.setdefault((pair.gap, side), ([due], [0.0]))
                owed = size if size and self._begun(pair, t, v)[1] == side else 0.0
                if times[-1] == due:
                    if owed == sizes[-1]:
                        continue
                    jumps.append(due)
                times.append(due)
                sizes.append(owed)
        return jumps

    def earlier(self, gap: int, side: int, t: float) -> float:
        """N that comes late to a side at t, along straight lines between the ends of steps.

        Of two values at one instant the one on the side of the step at hand.
        """
        if (gap, side) not in self.past:
            return 0.0
        times, sizes = self.past[gap, side]
        ends = self.force_time is not None and t > self.force_time
        k = (bisect_left if ends else bisect_right)(times, t)
        if k in (0, len(times)):
            return sizes[-1] if k else 0.0
        a, b = times[k - 1], times[k]
        return sizes[k - 1] + (sizes[k] - sizes[k - 1]) * (t - a) / (b - a)

    def echoes(self, t: float) -> bool:
        """Does a push of the last moments still have to come?"""
        return t <= self.last_push + self.world.delay

    def _outside(self, t: float, v: PerCart) -> dict[tuple[str, int], float]:
        return super()._outside(t, v) | {(self.name, k): f for k, f in enumerate(self.nowhere)}


def _apart(gap: int, push: PerCart, links: dict[tuple[str, int], float]) -> Any:
    """N. What pushes the two of a gap apart by the scene's own laws."""
    return push[gap] + sum(f for (_, place), f in links.items() if place == gap and f > 0.0)
