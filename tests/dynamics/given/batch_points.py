"""The points of a batch, and what the engine says at one of them."""

from __future__ import annotations

from typing import Any

from sim.dynamics.loop.run import run
from sim.laws.many import outcome_known
from sim.scene import apply_changes, read_scene
from sim.scene.laws import laws

LAWS = [law for law in laws() if outcome_known(law)]
FINITE = [law for law in LAWS if law not in ("instant", "velcro")]


def spread(low: float, high: float, count: int) -> tuple[float, ...]:
    return tuple(low + (high - low) * k / (count - 1) for k in range(count))


def by_engine(plain: dict[str, Any], changes: dict[str, float], show: tuple[str, str]) -> float:
    done = run(read_scene(apply_changes(plain, changes)))
    if show[0] == "v":
        return done.v[[cart.name for cart in done.scene.carts].index(show[1])]
    if show[0] == "warmed":
        return done.ledger.warmed
    peaks = [
        e.force
        for e in done.record.events
        if e.kind == "peak" and list(e.bodies) == show[1].split("-")
    ]
    return max([force or 0.0 for force in peaks], default=0.0)
