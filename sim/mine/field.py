"""The forces of a scene whose contacts somebody wrote.

What the two sides of a gap answer differently is booked under the name OWN: a force on one cart
that no body gave. A law that keeps Newton's third never has such an entry.
"""

from __future__ import annotations

from typing import Any

from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.pairs import Pair, PerCart
from sim.mine.contact import WrittenForce, side_of
from sim.mine.instance import Instance, read_law
from sim.scene.model import Scene

OWN = "own-law"
"""Name of what comes from nowhere, in accounts and columns."""


class WrittenField(Field):
    """`instances`: one life of each law in this run, by its file."""

    def __init__(self, scene: Scene, *, right_first: bool = False) -> None:
        super().__init__(scene)
        self.instances = {
            file: Instance(read_law(text, file)) for file, text in scene.written.items()
        }
        self.written: list[tuple[Pair, WrittenForce]] = []
        self.nowhere: PerCart = [0.0] * self.count  # N on each cart
        for pair in self.pairs:
            if pair.contact.written:
                force = self._force(pair, right_first=right_first)
                pair.force = force
                self.written.append((pair, force))

    def _force(self, pair: Pair, *, right_first: bool) -> WrittenForce:
        names = self.scene.names_at(pair.gap)
        masses = [None if k is None else self.mass[k] for k in (pair.left, pair.right)]
        left, right = (side_of(name, mass) for name, mass in zip(names, masses, strict=True))
        contact = pair.contact
        return WrittenForce(
            self.instances[contact.law],
            (left, right),
            contact.stiffness or 0.0,
            1.0 if contact.restitution is None else contact.restitution,
            right_first,
        )

    @property
    def calls(self) -> int:
        """How often the functions were asked."""
        return sum(instance.calls for instance in self.instances.values())

    @property
    def unequal(self) -> bool:
        """Have two sides ever answered differently?"""
        return any(force.apart.odd for _, force in self.written)

    def forces(
        self, t: Any, s: PerCart, v: PerCart
    ) -> tuple[PerCart, dict[tuple[str, int], Any], PerCart]:
        """As in any scene, after every pair was told of the instant."""
        for pair, force in self.written:
            left = 0.0 if pair.left is None else v[pair.left]
            right = 0.0 if pair.right is None else v[pair.right]
            force.look(t, left, right)
        return super().forces(t, s, v)

    def _total(
        self, t: Any, v: PerCart, push: PerCart, links: dict[tuple[str, int], float]
    ) -> PerCart:
        total = super()._total(t, v, push, links)
        extra = [0.0] * self.count
        for pair, force in self.written:
            if pair.left is not None:
                extra[pair.left] -= force.odd
            if pair.right is not None:
                extra[pair.right] -= force.odd
        self.nowhere = extra
        return [a + b for a, b in zip(total, extra, strict=True)]

    def _outside(self, t: float, v: PerCart) -> dict[tuple[str, int], float]:
        return super()._outside(t, v) | {(OWN, k): f for k, f in enumerate(self.nowhere) if f}
