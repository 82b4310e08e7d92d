"""The effects of a run, gathered by what they act on. A scene without effects has none of this.

A body may be several carts that stick together: what acts on them adds up. Loads are kept until a
push begins or ends.
"""

from __future__ import annotations

import math
from collections import defaultdict
from dataclasses import dataclass

from sim.dynamics.effects import Link, Pull, acting
from sim.dynamics.effects.base import Burst
from sim.scene.model import Scene


@dataclass(frozen=True, slots=True)
class Load:
    """All that acts on one body besides its neighbours: sums in N, N s/m, N s²/m², N."""

    pulls: tuple[Pull, ...] = ()
    steady: float = 0.0
    linear: float = 0.0
    quadratic: float = 0.0
    kinetic: float = 0.0
    static: float = 0.0
    grips: bool = False


NO_LOAD = Load()


class Forces:
    """The effects of one scene at work, at a present time that moves on."""

    def __init__(self, scene: Scene) -> None:
        self._acting = acting(scene)
        self.time = 0.0
        self.used: defaultdict[str, int] = defaultdict(int)
        self._loads: dict[tuple[int, ...], Load] = {}
        gaps = range(len(scene.carts) + 1)
        self.links: list[tuple[Link, ...]] = [
            tuple(link for one in self._acting if (link := one.link(gap)) is not None)
            for gap in gaps
        ]
        self.bursts: tuple[Burst, ...] = tuple(b for one in self._acting for b in one.bursts())
        switches = {t for one in self._acting for t in one.switches()}
        self.switches = sorted(t for t in switches if 0.0 < t < math.inf)

    def switches_after(self, t: float) -> bool:
        """Does anything begin, end or burst after t s?"""
        return any(s > t for s in (*self.switches, *(burst.time for burst in self.bursts)))

    def on_cart(self, cart: int, t: float) -> list[Pull]:
        """The pulls on one cart just after t s, for drawing."""
        return [p for one in self._acting if (p := one.pull(cart, t)) is not None]

    def grip_of(self, cart: int) -> float | None:
        """N. Kinetic friction on one cart; None where there is none."""
        grips = [grip.kinetic for one in self._acting if (grip := one.grip(cart)) is not None]
        return math.fsum(grips) if grips else None

    def move_to(self, t: float) -> None:
        """A switch has been reached, at t s."""
        self.time = t
        self._loads.clear()

    def load(self, carts: tuple[int, ...]) -> Load:
        """What acts on a body of these carts."""
        load = self._loads.get(carts)
        if load is None:
            load = self._loads[carts] = self._sum(carts)
        return load

    def _sum(self, carts: tuple[int, ...]) -> Load:
        pulls = tuple(
            pull
            for one in self._acting
            for cart in carts
            if (pull := one.pull(cart, self.time)) is not None
        )
        grips = tuple(
            grip for one in self._acting for cart in carts if (grip := one.grip(cart)) is not None
        )
        if not pulls and not grips:
            return NO_LOAD
        return Load(
            pulls,
            math.fsum(pull.steady for pull in pulls),
            math.fsum(pull.linear for pull in pulls),
            math.fsum(pull.quadratic for pull in pulls),
            math.fsum(grip.kinetic for grip in grips),
            math.fsum(grip.static for grip in grips),
            bool(grips),
        )

    def count(self, load: Load, links: tuple[Link, ...], times: int) -> None:
        """Book that the formulas of these effects were evaluated so many times."""
        for kind in {pull.kind for pull in load.pulls} | {link.kind for link in links}:
            self.used[kind] += times
        if load.grips:
            self.used["friction"] += times
