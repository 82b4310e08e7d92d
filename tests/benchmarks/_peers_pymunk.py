"""pymunk on the scenes of `_peers_scenes.py`: the same set-up as in `_peers.mjs`."""

from __future__ import annotations

import math
import time
from typing import Any

import pymunk

from tests.benchmarks._peers_scenes import Carts

HEIGHT, WALL = 0.1, 1.0
LONG_ENOUGH = 0.2


def build(scene: Carts) -> tuple[pymunk.Space, list[pymunk.Body]]:
    """Restitutions of two bodies are multiplied here, so each gets the root."""
    space = pymunk.Space()
    e = math.sqrt(scene.e)
    carts = []
    for mass, x, v in zip(scene.mass, scene.x, scene.v, strict=True):
        body = pymunk.Body(mass, math.inf)
        body.position, body.velocity = (x, 0), (v, 0)
        shape = pymunk.Poly.create_box(body, (0.2, HEIGHT))
        shape.elasticity, shape.friction = e, 0.0
        space.add(body, shape)
        carts.append(body)
    for at in (
        *([scene.left - WALL / 2] if scene.left is not None else []),
        *([scene.right + WALL / 2] if scene.right is not None else []),
    ):
        body = pymunk.Body(body_type=pymunk.Body.STATIC)
        body.position = (at, 0)
        shape = pymunk.Poly.create_box(body, (WALL, HEIGHT))
        shape.elasticity, shape.friction = e, 0.0
        space.add(body, shape)
    return space, carts


def run(scene: Carts, dt: float) -> list[list[float]]:
    """x and v of each cart at the end."""
    space, carts = build(scene)
    for _ in range(round(scene.until / dt)):
        space.step(dt)
    return [[body.position.x, body.velocity.x] for body in carts]


def seconds(scene: Carts, dt: float) -> float:
    """Of all steps of one run; the best of several."""
    best, spent = math.inf, 0.0
    while spent < LONG_ENOUGH:
        space, carts = build(scene)
        start = time.perf_counter()
        for _ in range(round(scene.until / dt)):
            space.step(dt)
            [(body.position.x, body.velocity.x) for body in carts]
        took = time.perf_counter() - start
        best, spent = min(best, took), spent + took
    return best


def results(scenes: tuple[Carts, ...], dt: float) -> dict[str, Any]:
    """As `_peers.mjs` gives them."""
    return {
        "engine": "pymunk",
        "version": pymunk.version,
        "ends": {s.name: [run(s.phase(k), dt) for k in range(s.phases)] for s in scenes},
        "seconds": {s.name: seconds(s, dt) for s in scenes},
    }
