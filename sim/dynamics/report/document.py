"""A finished run as one plain JSON object, format 1. SI units, no NaN, no Infinity."""

from __future__ import annotations

import math
from typing import Any

from sim.dynamics.report.plan import Phase, plan
from sim.dynamics.report.warnings import warnings
from sim.dynamics.result.finished import Run
from sim.dynamics.result.ledger import kinetic

FORMAT = 1


def report(run: Run) -> dict[str, Any]:
    """What `carts run --json` prints."""
    names = [cart.name for cart in run.scene.carts]
    ledger, record, outcome = run.ledger, run.record, run.outcome
    document: dict[str, Any] = {
        "format": FORMAT,
        "outcome": {"kind": outcome.kind, "sentence": outcome.sentence},
        "plan": [phase_object(phase) for phase in plan(run)],
    }
    if record.keep_events:
        document["events"] = [
            {
                "t": event.t,
                "kind": event.kind,
                "bodies": list(event.bodies),
                "before": event.before,
                "after": event.after,
                "impulse": event.impulse,
                "force": event.force,
            }
            for event in record.events
        ]
    else:
        document["event_counts"] = dict(record.counts)
    document |= {
        "warnings": [{"code": w.code, "message": w.message} for w in warnings(run)],
        "final": {
            "t": run.t,
            "x": dict(zip(names, run.x, strict=True)),
            "v": dict(zip(names, run.v, strict=True)),
        },
        "energy": {
            "initial": ledger.energy_initial,
            "final": ledger.energy_final,
            "warmed": ledger.warmed,
            "parts": energy_parts(run),
        },
        "momentum": {
            "initial": ledger.momentum_initial,
            "final": ledger.momentum_final,
            "external": ledger.external,
            "by": ledger.impulses,
        },
        "work": ledger.works,
        "evaluations": {"effects": dict(run.effects), "solvers": dict(run.solvers)},
    }
    return {key: finite(value) for key, value in document.items()}


def energy_parts(run: Run) -> dict[str, dict[str, float]]:
    """J at both ends, by where it is: in motion, in bumpers, and in each effect that stores it."""
    scene, ledger = run.scene, run.ledger
    start = [cart.velocity for cart in scene.carts]
    parts = {
        "kinetic": (kinetic(scene, start), kinetic(scene, run.v)),
        "bumpers": (ledger.stored_initial, ledger.stored_final),
        **ledger.potential,
    }
    return {name: {"initial": first, "final": last} for name, (first, last) in parts.items()}


def phase_object(phase: Phase) -> dict[str, Any]:
    """One entry of the plan."""
    return {
        "from": phase.begin,
        "until": phase.until,
        "tier": phase.tier,
        "solver": phase.solver,
        "why": phase.why,
        "packages": list(phase.packages),
    }


def finite(value: Any) -> Any:
    """The same value with null for NaN and infinity, and 0 for −0."""
    if isinstance(value, float):
        return (value or 0.0) if math.isfinite(value) else None
    if isinstance(value, dict):
        return {key: finite(item) for key, item in value.items()}
    if isinstance(value, list):
        return [finite(item) for item in value]
    return value
