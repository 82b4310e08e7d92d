"""Where the energy of a run is at every sample, for a reader who opens the ledger.

    {"id": 9, "kind": "energy", "scene": {...}, "set": {...}}

is answered by `parts`, the names of the columns after t, in J, and by `carts`, the number of
columns behind them: the kinetic energy of each. All of it is drawn in straight lines: a flight
under a steady force has more samples than the run has, which is drawn in cubics.
"""

from __future__ import annotations

from array import array
from collections.abc import Mapping
from typing import Any

from sim.bridge.protocol import MOST_EVENTS_DRAWN, MOST_STEPS_DRAWN, plain_of
from sim.dynamics.loop.run import run
from sim.dynamics.result.energy_parts import energy_parts
from sim.dynamics.result.trajectory import trajectory
from sim.scene import read_scene

PER_FLIGHT = 256
"""A straight line leaves a parabola by at most ¼ (1/256)² = 4e-6 of its rise."""


def energy_answer(request: Mapping[str, Any]) -> tuple[dict[str, Any], array[float]]:
    """Header and numbers; raises SceneError or UnsolvedError for what cannot be run."""
    plain = plain_of(request)
    finished = run(read_scene(plain), max_events=MOST_EVENTS_DRAWN, max_steps=MOST_STEPS_DRAWN)
    samples = trajectory(finished, per_flight=PER_FLIGHT)
    parts = energy_parts(finished, samples)
    numbers = array("d", samples.columns[("t",)])
    for column in parts.values():
        numbers.extend(column)
    for cart in finished.scene.carts:
        numbers.extend(cart.mass * v * v / 2 for v in samples.columns[("v", cart.name)])
    carts = len(finished.scene.carts)
    return {"parts": list(parts), "carts": carts, "rows": samples.rows}, numbers
