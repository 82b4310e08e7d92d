"""A finished run, as a value."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

from sim.dynamics.forces import Forces
from sim.dynamics.ledger import Ledger
from sim.dynamics.outcome import Outcome
from sim.dynamics.record import Record
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
    outcome: Outcome
    record: Record
    ledger: Ledger
    solvers: Counter[str]
    effects: Counter[str]
    """How often the formulas of each effect were evaluated."""
    forces: Forces | None = None


def outcome_of(
    scene: Scene, t: float, v: list[float], stopped: str | None, *, moving_on: bool
) -> Outcome:
    """Why a run ended at t [s] with velocities v.

    `stopped`: what there was too much of. `moving_on`: forces are left that will move a cart.
    """
    if stopped is not None:
        return Outcome(
            "too-many-events",
            f"The run was stopped at t = {t:.6g} s after {stopped}. Ask for an earlier end "
            "(until), more events (--max-events), a larger restitution, or stiffnesses and masses "
            "that differ less.",
        )
    fastest = max(abs(cart.velocity) for cart in scene.carts)
    if all(abs(speed) <= REST * fastest for speed in v) and not moving_on:
        return Outcome("came-to-rest", f"Every cart is at rest at t = {t:.6g} s.")
    return Outcome("reached-end", f"The run reached its end at t = {t:.6g} s.")
