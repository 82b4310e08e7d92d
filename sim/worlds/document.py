"""A run of a world as one JSON object: that of an ordinary run, and what makes it impossible."""

from __future__ import annotations

from typing import Any

from sim.dynamics.report.document import finite, report
from sim.scene.said import said
from sim.worlds.breaks import Broken
from sim.worlds.follow import WorldRun


def document(done: WorldRun, found: Broken) -> dict[str, Any]:
    """What `carts run --world … --json` prints; `impossible` names the world."""
    kind, told = done.world.kind, report(done.run)
    told["plan"] = [
        {
            "from": 0.0,
            "until": done.run.t,
            "tier": None,
            "solver": "rk4-events",
            "why": said("impossible: a world in which {what}", what=said(kind.says)),
            "packages": [],
        }
    ]
    broken = {
        "momentum": found.momentum,
        "most": found.most,
        "energy": found.energy,
        "sentences": found.sentences,
    }
    return {
        "impossible": [kind.name],
        "belief": kind.belief,
        **told,
        "broken": {key: finite(value) for key, value in broken.items()},
    }
