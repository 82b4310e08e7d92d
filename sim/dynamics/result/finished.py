"""A finished run, as a value."""

from __future__ import annotations

from dataclasses import dataclass

from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.outcome import Outcome
from sim.dynamics.result.record import Record
from sim.dynamics.state.loads import Forces
from sim.scene.model import Scene

REST = 1e-12
"""Of the greatest speed at the start. Slower than this at the end is called "at rest", in words
only: it is what rounding leaves of nought. It changes no number."""


@dataclass(frozen=True, slots=True)
class Run:
    """A finished run: where everything is, what happened, and what it took."""

    scene: Scene
    t: float
    x: tuple[float, ...]  # m, per cart from left to right
    v: tuple[float, ...]  # m/s
    record: Record
    ledger: Ledger
    solvers: dict[str, int]
    effects: dict[str, int]
    """How often the formulas of each effect were evaluated."""
    forces: Forces | None
    stopped: str | None
    """What there was too much of, if the run was stopped."""

    @property
    def outcome(self) -> Outcome:
        """Why the run ended; made when asked for."""
        t = self.t
        if self.stopped is not None:
            return Outcome(
                "too-many-events",
                f"The run was stopped at t = {t:.6g} s after {self.stopped}. Ask for an earlier "
                "end (until), more events (--max-events), a larger restitution, or stiffnesses "
                "and masses that differ less.",
            )
        fastest = max(abs(cart.velocity) for cart in self.scene.carts)
        to_come = self.forces is not None and self.forces.switches_after(t)
        if all(abs(speed) <= REST * fastest for speed in self.v) and not to_come:
            return Outcome("came-to-rest", f"Every cart is at rest at t = {t:.6g} s.")
        return Outcome("reached-end", f"The run reached its end at t = {t:.6g} s.")
