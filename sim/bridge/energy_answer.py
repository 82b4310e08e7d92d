"""Where the energy of a run is at every sample, for a reader who opens the ledger.

    {"id": 9, "kind": "energy", "scene": {...}, "set": {...}}

is answered by `parts`, the names of the columns after t, and the columns in J. The samples are
those of the run with the same values.
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


def energy_answer(request: Mapping[str, Any]) -> tuple[dict[str, Any], array[float]]:
    """Header and numbers; raises SceneError or UnsolvedError for what cannot be run."""
    plain = plain_of(request)
    finished = run(read_scene(plain), max_events=MOST_EVENTS_DRAWN, max_steps=MOST_STEPS_DRAWN)
    samples = trajectory(finished)
    parts = energy_parts(finished, samples)
    numbers = array("d", samples.columns[("t",)])
    for column in parts.values():
        numbers.extend(column)
    return {"parts": list(parts), "rows": samples.rows}, numbers
