"""Momentum and energy: what every change is due to.

    momentum   initial + external (walls) = final
    energy     initial = final + warmed            (kinetic + stored in bumpers)

`warmed` went into the bumpers: each contact adds what it does not give back. Totals are summed
with compensation, so that a million contacts do not blur them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

from sim.scene.model import Scene


@dataclass(slots=True)
class Ledger:
    """Totals of one run in J and N s."""

    energy_initial: float = 0.0
    energy_final: float = 0.0
    momentum_initial: float = 0.0
    momentum_final: float = 0.0
    stored_initial: float = 0.0
    stored_final: float = 0.0
    _warmed: list[float] = field(default_factory=lambda: [0.0, 0.0])
    _external: list[float] = field(default_factory=lambda: [0.0, 0.0])

    def warm(self, energy: float) -> None:
        """A contact kept `energy` [J]."""
        _add(self._warmed, energy)

    def push_from_outside(self, impulse: float) -> None:
        """A wall gave the carts `impulse` [N s], + to the right."""
        _add(self._external, impulse)

    @property
    def warmed(self) -> float:
        """J."""
        return self._warmed[0] + self._warmed[1]

    @property
    def external(self) -> float:
        """N s."""
        return self._external[0] + self._external[1]


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


def close(ledger: Ledger, scene: Scene, v: Sequence[float]) -> None:
    """Fill in the totals at both ends of a run."""
    start = [cart.velocity for cart in scene.carts]
    ledger.momentum_initial = momentum(scene, start)
    ledger.momentum_final = momentum(scene, v)
    ledger.energy_initial = kinetic(scene, start) + ledger.stored_initial
    ledger.energy_final = kinetic(scene, v) + ledger.stored_final
