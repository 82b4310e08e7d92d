"""What stepping costs beside the exact outcome, on the standard scene, in one process."""

from __future__ import annotations

from typing import Any

from sim.dynamics.cost.measure import CostRow, cost
from tests import registry

NEAR = 0.01
"""Of the closing speed. Methods that are wronger than this are not worth a comparison."""


def rows() -> list[dict[str, Any]]:
    """One row per goal."""
    scene = registry.scene("paper-two-carts")
    closing = scene.carts[0].velocity - scene.carts[1].velocity
    found = [row for row in cost(scene) if isinstance(row, CostRow)]
    good = [
        row
        for row in found
        if not row.method.startswith("exact") and (row.error_v or 0.0) <= NEAR * closing
    ]
    cheapest = min(good, key=lambda row: row.time_ratio)
    return [
        {
            "name": "exact outcome: error of the velocities",
            "value": found[0].error_v,
            "unit": "m/s",
            "goal": 4e-16,
            "reference": "rational arithmetic",
        },
        {
            "name": f"cheapest method within 1 % ({cheapest.method}) / exact outcome",
            "value": cheapest.time_ratio,
            "unit": "times the cost",
            "goal": 100,
            "reference": "same output, same process",
            "at_least": True,
        },
        {
            "name": "solver for any scene / exact outcome",
            "value": found[1].time_ratio,
            "unit": "times the cost",
            "goal": 20,
            "reference": "the formula alone",
        },
    ]
