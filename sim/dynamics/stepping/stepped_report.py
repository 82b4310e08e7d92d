"""A stepped run as one plain JSON object, with what its accounts leave unexplained."""

from __future__ import annotations

from typing import Any

from sim.dynamics.report.document import finite, report
from sim.dynamics.stepping.methods import ADAPTIVE
from sim.dynamics.stepping.recorded import SteppedRun
from sim.scene.said import said


def stepped_report(result: SteppedRun) -> dict[str, Any]:
    """What `carts run --method … --json` prints: format 1, the plan and the imbalance its own."""
    run, choice = result.run, result.choice
    document = report(run)
    asked = (
        said("asked for: step {size}, for the whole run", size=f"{choice.step:.6g} s")
        if choice.step
        else said(
            "asked for: relative tolerance {size}, for the whole run", size=f"{choice.rtol:.3g}"
        )
    )
    document["plan"] = [
        {
            "from": 0.0,
            "until": run.t,
            "tier": None,
            "solver": choice.method,
            "why": said("{first}; {last}", first=asked, last=said("it is not exact")),
            "packages": ["numpy", "scipy"] if choice.method in ADAPTIVE else [],
        }
    ]
    document["energy"]["imbalance"] = finite(result.lost_energy)
    document["momentum"]["imbalance"] = finite(result.lost_momentum)
    document["steps"] = result.steps
    return document
