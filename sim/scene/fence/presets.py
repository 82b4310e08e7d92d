"""Ready-made settings of a scene: a button each, with values that a lesson chose."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sim.scene.changes import apply_changes, resolve
from sim.scene.fence.controls import number_of
from sim.scene.problem import Path, Problem, SceneError
from sim.scene.read import collect_scene, read_scene
from sim.scene.reading.effects import all_effects
from sim.scene.tables import mapping

HINT = "presets: {elastic: {contact.restitution: 1}, heavy hits light: {A.mass: 4 kg}}"


def read_presets(
    value: object, plain: Mapping[str, Any], problems: list[Problem]
) -> dict[str, dict[str, Any]]:
    """The presets by name; each must make a scene that makes sense out of `plain`."""
    table = mapping(value, ("presets",), problems, HINT)
    presets: dict[str, dict[str, Any]] = {}
    for name, changes in (table or {}).items():
        path: Path = ("presets", name)
        listed = mapping(changes, path, problems, HINT)
        if listed is None:
            continue
        try:
            changed = apply_changes(plain, listed)
        except SceneError as error:
            problems.extend(Problem(path, p.code, p.message, p.hint) for p in error.problems)
            continue
        found: list[Problem] = []
        collect_scene(changed, found)
        targets = {resolve(plain, str(target)): target for target in listed}
        for p in found:
            at = (*path, targets[p.path]) if p.path in targets else path
            problems.append(Problem(at, p.code, p.message, p.hint))
        presets[str(name)] = dict(listed)
    return presets


def numbers_of(plain: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, float]:
    """The numbers of a preset in SI, by their paths: a page looks for them in the run it shows."""
    changed = apply_changes(plain, changes)
    scene = read_scene(changed)
    effects = all_effects(changed, scene)
    found = {target: number_of(target, scene, effects) for target in changes}
    return {target: number[2] for target, number in found.items() if number is not None}
