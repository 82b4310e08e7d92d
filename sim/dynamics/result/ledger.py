"""Momentum and energy: what every change is due to.

    momentum   initial + external = final                 external: walls, and effects by name
    energy     initial + work = final + warmed            kinetic, and stored: in bumpers, springs,
                                                          magnets, and height on an incline

`warmed` went into the bumpers: each contact adds what it does not give back. `work` is that of
push and release, and, below nought, of friction, drag and the dampers of springs. Height is nought
where each cart starts. Totals are summed with compensation, so that a million contacts do not
blur them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from sim.scene.effects import kinds
from sim.scene.model import Scene


class Ledger:
    """Totals of one run in J and N s. Those at both ends are summed when asked for."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.v_final: list[float] = []
        self.stored_initial = 0.0
        self.stored_final = 0.0
        self._links: dict[str, tuple[float, float]] = {}
        self._warmed = [0.0, 0.0]
        self._impulses: dict[str, list[float]] = {}
        self._works: dict[str, list[float]] = {}
        self._heights: dict[str, list[float]] = {}
        self._stores = {e.kind for e in scene.effects if kinds()[e.kind].stores == "place"}

    def dissipate(self, energy: float) -> None:
        """A contact kept `energy` [J]."""
        _add(self._warmed, energy)

    def push_from_outside(self, impulse: float, by: str = "walls") -> None:
        """`by` gave the carts `impulse` [N s], + to the right."""
        _add(self._impulses.setdefault(by, [0.0, 0.0]), impulse)

    def work(self, by: str, energy: float) -> None:
        """An effect gave the carts `energy` [J]; what it had stored in their places, or else."""
        totals = self._heights if by in self._stores else self._works
        _add(totals.setdefault(by, [0.0, 0.0]), energy)

    def store(self, by: str, energy: float, *, first: bool) -> None:
        """A spring or magnets hold `energy` [J] at the start, or at the end."""
        start, end = self._links.get(by, (0.0, 0.0))
        self._links[by] = (start + energy, end) if first else (start, end + energy)

    @property
    def warmed(self) -> float:
        """J."""
        return self._warmed[0] + self._warmed[1]

    @property
    def external(self) -> float:
        """N s. By all together."""
        return math.fsum(part for total in self._impulses.values() for part in total)

    @property
    def impulses(self) -> dict[str, float]:
        """N s from outside, by name."""
        return {by: total[0] + total[1] for by, total in self._impulses.items()}

    @property
    def works(self) -> dict[str, float]:
        """J, by effect; left out is what was stored."""
        return {by: total[0] + total[1] for by, total in self._works.items()}

    def totals(self) -> tuple[float, ...]:
        """All sums kept so far: finite, or the run was none."""
        sums = (
            self._warmed,
            *self._impulses.values(),
            *self._works.values(),
            *self._heights.values(),
        )
        return tuple(part for total in sums for part in total)

    def imbalance(self) -> float:
        """How far initial + work = final + warmed is from true, as a part of all these energies."""
        first, last, warmed = self.energy_initial, self.energy_final, self.warmed
        works = list(self.works.values())
        stored = [abs(e) for ends in self.potential.values() for e in ends]
        stored += [abs(self.stored_initial), abs(self.stored_final)]
        moving = kinetic(self.scene, self.v_final) + kinetic(
            self.scene, [cart.velocity for cart in self.scene.carts]
        )
        scale = math.fsum([moving, abs(warmed), *map(abs, works), *stored, self._passed(), TINY])
        return abs(math.fsum([first, *works, -last, -warmed])) / scale

    def _passed(self) -> float:
        """J. Energy that came and went: where all rests at both ends, nothing else is in play.

        What gave p from outside has moved the carts, some of them with up to p²/(2 M).
        """
        pushed = math.fsum([abs(total[0] + total[1]) for total in self._impulses.values()])
        return PASSED * pushed * pushed / (2.0 * math.fsum([c.mass for c in self.scene.carts]))

    @property
    def potential(self) -> dict[str, tuple[float, float]]:
        """J per effect that stores energy: at the start and at the end."""
        heights = {by: (0.0, -(total[0] + total[1])) for by, total in self._heights.items()}
        return self._links | heights

    @property
    def momentum_initial(self) -> float:
        """N s."""
        return momentum(self.scene, [cart.velocity for cart in self.scene.carts])

    @property
    def momentum_final(self) -> float:
        """N s."""
        return momentum(self.scene, self.v_final)

    @property
    def energy_initial(self) -> float:
        """J. In motion and stored."""
        stored = math.fsum(start for start, _ in self.potential.values())
        moving = kinetic(self.scene, [cart.velocity for cart in self.scene.carts])
        return moving + self.stored_initial + stored

    @property
    def energy_final(self) -> float:
        """J. In motion and stored."""
        stored = math.fsum(end for _, end in self.potential.values())
        return kinetic(self.scene, self.v_final) + self.stored_final + stored


TINY = 1e-300
"""J. Where nothing moves, nothing is out of balance."""

PASSED = 1e-9
"""Of the energy that came and went: enough for rounding of it to be small beside, 1e-22 J of what
swung with 1e-4, too little to hide what is out of balance."""


def _add(total: list[float], term: float) -> None:
    """Neumaier's compensated sum: total = [sum, correction]."""
    new = total[0] + term
    if abs(total[0]) >= abs(term):
        total[1] += (total[0] - new) + term
    else:
        total[1] += (term - new) + total[0]
    total[0] = new


def kinetic(scene: Scene, v: Sequence[float]) -> float:
    """J."""
    return 0.5 * math.fsum([c.mass * s * s for c, s in zip(scene.carts, v, strict=True)])


def momentum(scene: Scene, v: Sequence[float]) -> float:
    """N s, + to the right."""
    return math.fsum([c.mass * s for c, s in zip(scene.carts, v, strict=True)])
