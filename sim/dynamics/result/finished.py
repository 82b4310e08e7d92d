"""A finished run, as a value."""

from __future__ import annotations

from dataclasses import dataclass

from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.outcome import Outcome
from sim.dynamics.result.record import Record
from sim.dynamics.result.stopped import Stopped
from sim.dynamics.state.loads import Forces
from sim.scene.model import Scene

REST = 1e-12
"""Of the greatest speed at the start. Slower than this at the end is called "at rest", in words
only: it is what rounding leaves of nought. It changes no number."""

TURNS = 1e-6
"""Of the acceleration that the greatest speed in the time of the run makes, or the loads alone. One
that has more than this at the end is not at rest but turns round, or starts."""


@dataclass(frozen=True, slots=True)
class Run:
    """A finished run: where everything is, what happened, and what it took."""

    scene: Scene
    t: float
    x: tuple[float, ...]  # m, per cart from left to right
    v: tuple[float, ...]  # m/s
    a: tuple[float, ...]  # m/s², just then
    record: Record
    ledger: Ledger
    solvers: dict[str, int]
    effects: dict[str, int]
    """How often the formulas of each effect were evaluated."""
    forces: Forces | None
    stopped: Stopped | None
    """What there was too much of, if the run was stopped."""

    @property
    def outcome(self) -> Outcome:
        """Why the run ended; made when asked for."""
        t = self.t
        if self.stopped is not None:
            return Outcome("too-many-events", self.stopped.sentence(self.scene, t))
        to_come = self.forces is not None and self.forces.switches_after(t)
        if self._rests() and not to_come:
            return Outcome("came-to-rest", f"Every cart is at rest at t = {t:.6g} s.")
        return Outcome("reached-end", f"The run reached its end at t = {t:.6g} s.")

    def _rests(self) -> bool:
        """Does every cart stand still, with nothing that accelerates it?"""
        carts, forces = self.scene.carts, self.forces
        fastest = max(abs(cart.velocity) for cart in carts)
        if any(abs(speed) > REST * fastest for speed in self.v):
            return False
        if not any(self.a):
            return True
        loads = (abs(forces.load((k,)).steady) / one.mass for k, one in enumerate(carts) if forces)
        usual = max(fastest / self.t, *loads, 0.0)
        return all(abs(a) <= TURNS * usual for a in self.a)
