"""The effects of a run, gathered by what they act on. A scene without effects has none of this.

A body may be several carts that stick together: what acts on them adds up. Loads are kept until a
push begins or ends.
"""

from __future__ import annotations

import math
from collections import defaultdict
from dataclasses import dataclass

from sim.effects.forces import (
    FRICTION,
    BodyForce,
    CoulombFriction,
    EnergyRelease,
    PairForce,
    checked,
)
from sim.scene.model import Scene


@dataclass(frozen=True, slots=True)
class Load:
    """All that acts on one body besides its neighbours: sums in N, N s/m, N s²/m², N."""

    forces: tuple[BodyForce, ...] = ()
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
        self._acting = checked(scene)
        self.time = 0.0
        self.used: defaultdict[str, int] = defaultdict(int)
        self._loads: dict[tuple[int, ...], Load] = {}
        gaps = range(len(scene.carts) + 1)
        self.links: list[tuple[PairForce, ...]] = [
            tuple(link for one in self._acting if (link := one.pair_force(gap)) is not None)
            for gap in gaps
        ]
        self.releases: tuple[EnergyRelease, ...] = tuple(
            release for one in self._acting for release in one.releases()
        )
        switches = {t for one in self._acting for t in one.switches()}
        self.switches = sorted(t for t in switches if 0.0 < t < math.inf)

    def switches_after(self, t: float) -> bool:
        """Does anything begin, end or set energy free after t s?"""
        return any(s > t for s in (*self.switches, *(release.time for release in self.releases)))

    def on_cart(self, cart: int, t: float) -> list[BodyForce]:
        """The forces on one cart just after t s, for drawing."""
        return [f for one in self._acting if (f := one.body_force(cart, t)) is not None]

    def friction_on(self, cart: int) -> CoulombFriction | None:
        """Dry friction on one cart, all kinds together; None where there is none."""
        grips = [grip for one in self._acting if (grip := one.friction(cart)) is not None]
        if not grips:
            return None
        kinetic, static = zip(*((grip.kinetic, grip.static) for grip in grips), strict=True)
        return CoulombFriction(math.fsum(kinetic), math.fsum(static))

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
        forces = tuple(
            force
            for one in self._acting
            for cart in carts
            if (force := one.body_force(cart, self.time)) is not None
        )
        grips = tuple(
            grip
            for one in self._acting
            for cart in carts
            if (grip := one.friction(cart)) is not None
        )
        if not forces and not grips:
            return NO_LOAD
        return Load(
            forces,
            math.fsum(force.steady for force in forces),
            math.fsum(force.linear for force in forces),
            math.fsum(force.quadratic for force in forces),
            math.fsum(grip.kinetic for grip in grips),
            math.fsum(grip.static for grip in grips),
            bool(grips),
        )

    def count(self, load: Load, links: tuple[PairForce, ...], times: int) -> None:
        """Book that the formulas of these effects were evaluated so many times."""
        if len(load.forces) == 1 and not links:
            self.used[load.forces[0].kind] += times
        else:
            kinds = [*(f.kind for f in load.forces), *(link.kind for link in links)]
            for kind in dict.fromkeys(kinds):
                self.used[kind] += times
        if load.grips:
            self.used[FRICTION] += times
