"""A run of written laws as one JSON object: that of an ordinary run, and what the law is."""

from __future__ import annotations

from typing import Any

from sim.dynamics.report.document import finite, report
from sim.mine.follow import METHOD, WrittenRun
from sim.scene.model import Scene
from sim.scene.said import said


def document(done: WrittenRun) -> dict[str, Any]:
    """What `carts run --json` prints of a scene that names a law in a file."""
    told = report(done.run)
    told["plan"] = plan_of(done.scene)
    told["laws"] = {"files": sorted(done.scene.written), "calls": done.calls}
    return {key: finite(value) for key, value in told.items()}


def plan_of(scene: Scene) -> list[dict[str, Any]]:
    """One phase: nothing is known of such a law that would make a part of the run exact."""
    why = said(
        "a law of your own ({file}): steps that follow a tolerance, with located touches",
        file=", ".join(scene.written),
    )
    return [
        {
            "from": 0.0,
            "until": scene.until,
            "tier": 3,
            "solver": METHOD,
            "why": why,
            "packages": [],
        }
    ]
