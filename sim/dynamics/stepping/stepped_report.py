"""A stepped run as one plain JSON object, with what its accounts leave unexplained."""

from __future__ import annotations

from typing import Any

from sim.dynamics.report.document import finite, report
from sim.dynamics.stepping.methods import ADAPTIVE
from sim.dynamics.stepping.recorded import SteppedRun
from sim.scene.said import said


def stepped_report(result: SteppedRun) -> dict[str, Any]:
    """What `carts run --method … --json` prints: format 1, the plan and the imbalance its own."""
    run, way = result.run, result.way
    document = report(run)
    asked = (
        said("asked for: step {size}, for the whole run", size=f"{way.step:.6g} s")
        if way.step
        else said("asked for: relative tolerance {size}, for the whole run", size=f"{way.rtol:.3g}")
    )
    document["plan"] = [
        {
            "from": 0.0,
            "until": run.t,
            "tier": None,
            "solver": way.method,
            "why": said("{first}; {last}", first=asked, last=said("it is not exact")),
            "packages": ["numpy", "scipy"] if way.method in ADAPTIVE else [],
        }
    ]
    document["energy"]["imbalance"] = finite(result.lost_energy)
    document["momentum"]["imbalance"] = finite(result.lost_momentum)
    document["steps"] = result.steps
    return document
