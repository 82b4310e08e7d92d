"""A hint where a slope was probably meant in degrees: a plain number is in rad."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sim.pages.blocks.scene_block import SceneBlock
from sim.pages.findings import Finding
from sim.scene.problem import Problem

STEEP = math.radians(20.0)
"""rad. No track of a school is steeper; a scene may be."""


def steep_slopes(scene: SceneBlock) -> Iterator[Finding]:
    """Slopes without a unit that are steeper than any track."""
    for k, effect in enumerate(scene.fence.plain.get("effects", [])):
        for kind, given in effect.items():
            angle = given.get("angle") if isinstance(given, dict) else None
            if isinstance(angle, (int, float)) and abs(angle) > STEEP:
                told = (
                    f"a plain angle is in rad: {angle:g} is {math.degrees(angle):.0f}°. "
                    f"For {angle:g}° write angle: {angle:g} deg"
                )
                problem = Problem(("effects", k, kind, "angle"), "steep", told, "")
                yield scene.places.finding(problem).as_hint(told)
