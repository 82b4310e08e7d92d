"""A hint where a preset goes further than the slider of a number: the slider shows another one."""

from __future__ import annotations

from collections.abc import Iterator

from sim.pages.blocks.scene_block import SceneBlock
from sim.pages.findings import Finding
from sim.scene.fence.presets import numbers_of
from sim.scene.problem import Problem


def presets_beyond_sliders(scene: SceneBlock) -> Iterator[Finding]:
    """Presets that run, and whose number no slider of theirs can show."""
    sliders = {control.set: control for control in scene.fence.controls}
    for name, changes in scene.fence.presets.items():
        for target, value in numbers_of(scene.fence.plain, changes).items():
            slider = sliders.get(target)
            if slider and not slider.low <= value <= slider.high:
                told = (
                    f"{changes[target]} is outside of the control of {target}: its slider will "
                    "stand at its end. Widen from and to, or change the preset"
                )
                problem = Problem(("presets", name, target), "out-of-reach", told, "")
                yield scene.places.finding(problem).as_hint(told)
