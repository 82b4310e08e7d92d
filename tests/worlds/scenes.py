"""Scenes for worlds, as an author writes them."""

from __future__ import annotations

from typing import Any

from sim.scene import Scene, read_scene
from sim.worlds.describe import World, read_worlds
from sim.worlds.follow import WorldRun, follow

HEAVY_INTO_LIGHT: dict[str, Any] = {
    "carts": {
        "A": {"mass": 2.0, "position": 0.4, "velocity": 0.4},
        "B": {"mass": 0.5, "position": 1.2},
    },
    "contact": {"restitution": 0.8, "stiffness": 100},
    "until": 3.0,
}
LIGHT_INTO_HEAVY: dict[str, Any] = {
    "carts": {
        "A": {"mass": 0.5, "position": 0.4, "velocity": 0.7},
        "B": {"mass": 1.5, "position": 1.2, "velocity": -0.1},
    },
    "contact": {"restitution": 0.5, "stiffness": 300},
    "until": 2.5,
}
PARTLY_PUSHED: dict[str, Any] = {
    "carts": {
        "A": {"mass": 0.7, "position": 0.4, "velocity": 0.3},
        "B": {"mass": 0.5, "position": 1.0},
    },
    "contact": {"restitution": 1.0, "stiffness": 200},
    "effects": [{"drag": {"linear": 0.05}}],
    "until": 3.0,
}
PAIRS = {
    "heavy-into-light": HEAVY_INTO_LIGHT,
    "light-into-heavy": LIGHT_INTO_HEAVY,
    "with-drag": PARTLY_PUSHED,
}


def scene(plain: dict[str, Any]) -> Scene:
    return read_scene(plain)


def named(plain: dict[str, Any], world: object) -> World:
    """The world that an author writes in that scene."""
    problems: list[Any] = []
    (found,) = read_worlds([world], scene(plain), problems)
    assert not problems
    return found


def followed(plain: dict[str, Any], world: object) -> WorldRun:
    return follow(scene(plain), named(plain, world))
