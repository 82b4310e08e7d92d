"""A scene that hides its forces until a reader has found one, and has none that can be found."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from sim.pages.blocks.scene_block import SceneBlock
from sim.pages.findings import Finding
from sim.scene.problem import Problem

ALONE = 0.02
"""Of the impulse, as in `mean-forces.js`: by more m Δv differs where another force acts too."""


def forces_nobody_finds(scene: SceneBlock, header: Mapping[str, Any]) -> list[Finding]:
    """A warning where two touch and part, but other forces act meanwhile in each contact."""
    if scene.fence.forces != "hidden":
        return []
    masses = {body["name"]: body["mass"] for body in header["bodies"]}
    parted = [event for event in header["events"] if event["kind"] == "separate"]
    if not parted or any(_alone(event, masses) for event in parted):
        return []
    message = "forces: hidden, but no reader finds one: another force acts while two touch"
    hint = "m Δv/Δt is then not the contact force; leave the effect out, or write forces: none"
    finding = scene.places.finding(Problem(("forces",), "no-force-to-find", message, hint))
    return [replace(finding, severity="warning")]


def _alone(event: Mapping[str, Any], masses: Mapping[str, float]) -> bool:
    """Whether both velocities changed as the impulse of the contact alone would change them."""
    impulse, left = event["impulse"], event["bodies"][0]
    return impulse > 0.0 and all(
        abs(
            masses[name] * (after - event["before"][name]) - (-impulse if name == left else impulse)
        )
        <= ALONE * impulse
        for name, after in event["after"].items()
    )
