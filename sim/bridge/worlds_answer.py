"""A scene in a world that does not exist, as the wire delivers it.

    {"id": 9, "kind": "worlds", "scene": {...}, "set": {...}, "worlds": [...], "world": "name"}

`worlds` is the scene's own key: only what it names is run. The answer is a run like any other (see
`protocol`) with `impossible`, the world's name; `says`, what is different there; `broken`, one
sentence for each law; and columns ("on", pair, body) [N]: the push on each of the two.
"""

from __future__ import annotations

from array import array
from collections.abc import Mapping
from typing import Any

from sim.bridge.protocol import effects_of, plain_of, track_of, wire
from sim.scene import Problem, SceneError, read_scene
from sim.scene.said import said
from sim.scene.said import wire as said_by
from sim.worlds.breaks import broken
from sim.worlds.describe import read_worlds
from sim.worlds.document import document
from sim.worlds.follow import follow


def worlds_answer(request: Mapping[str, Any]) -> tuple[dict[str, Any], array[float]]:
    """Header and numbers; raises SceneError or UnsolvedError for what cannot be run."""
    plain = plain_of(request)
    scene = read_scene(plain)
    problems: list[Problem] = []
    named = read_worlds(request.get("worlds") or [], scene, problems)
    if problems:
        raise SceneError(problems)
    world = next((one for one in named if one.kind.name == request.get("world")), None)
    if world is None:
        message = said("the scene does not name this world")
        problem = Problem(("world",), "unknown-world", message, "")
        raise SceneError([problem])
    done = follow(scene, world)
    found = broken(done)
    header, numbers = wire(done.run, done.samples, document(done, found))
    header["track"] = track_of(scene)
    header["effects"] = effects_of(plain, scene)
    header["says"] = said_by(said(world.kind.says))
    header["broken"] = [said_by(sentence) for sentence in found.sentences]
    return header, numbers
