"""MuJoCo on the scenes of `_peers_scenes.py`: boxes on slides, at its own step.

Its contacts are soft: a spring and a damper per unit mass, a = −k r − b v. Both follow from how
long a touch lasts, π/w, and from the restitution that a damped half swing returns:

    ζ = −ln e / √(π² + ln² e)        w0 = w / √(1 − ζ²)        k = w0²        b = 2 ζ w0
"""

from __future__ import annotations

import math
import time
from typing import Any

import mujoco

from tests.benchmarks._peers_scenes import DT, Carts

STEP = 0.002
"""s. The step it comes with; at 1/60 s a touch of ten steps would be 8 cm deep."""

STEPS_OF_A_TOUCH = 10
"""With 4 of them e is wrong by 4 %, with 20 carts are twice as deep in each other."""

WALL = 1.0
LONG_ENOUGH = 0.2


def build(scene: Carts) -> tuple[Any, Any]:
    """Model and state."""
    swing = math.pi / (STEPS_OF_A_TOUCH * STEP)
    loss = -math.log(scene.e)
    zeta = loss / math.hypot(math.pi, loss)
    own = swing / math.sqrt(1 - zeta * zeta)
    carts = "".join(
        f'<body pos="{x!r} 0 0"><joint type="slide" axis="1 0 0"/>'
        f'<geom type="box" size="0.1 0.05 0.05" mass="{mass}"/></body>'
        for mass, x in zip(scene.mass, scene.x, strict=True)
    )
    ends = [] if scene.left is None else [scene.left - WALL / 2]
    ends += [] if scene.right is None else [scene.right + WALL / 2]
    walls = "".join(f'<geom type="box" size="{WALL / 2} 0.05 0.05" pos="{at} 0 0"/>' for at in ends)
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><option timestep="{STEP}" gravity="0 0 0"/><default><geom condim="1" '
        f'solref="{-own * own} {-2 * zeta * own}" solimp="0.9999 0.9999 0.001"/></default>'
        f"<worldbody>{walls}{carts}</worldbody></mujoco>"
    )
    state = mujoco.MjData(model)
    state.qvel[:] = scene.v
    return model, state


def run(scene: Carts) -> list[list[float]]:
    """x and v of each cart at the end."""
    model, state = build(scene)
    for _ in range(round(scene.until / STEP)):
        mujoco.mj_step(model, state)
    return [
        [x + float(way), float(v)]
        for x, way, v in zip(scene.x, state.qpos, state.qvel, strict=True)
    ]


def seconds(scene: Carts) -> float:
    """Of all steps of one run, with 60 states a second; the best of several."""
    best, spent = math.inf, 0.0
    while spent < LONG_ENOUGH:
        model, state = build(scene)
        start, seen = time.perf_counter(), 0.0
        for k in range(round(scene.until / STEP)):
            mujoco.mj_step(model, state)
            if k * STEP >= seen:
                state.qpos.tolist(), state.qvel.tolist()
                seen += DT
        took = time.perf_counter() - start
        best, spent = min(best, took), spent + took
    return best


def results(scenes: tuple[Carts, ...]) -> dict[str, Any]:
    """As `_peers.mjs` gives them."""
    return {
        "engine": "MuJoCo",
        "version": mujoco.__version__,
        "ends": {s.name: [run(s.phase(k)) for k in range(s.phases)] for s in scenes},
        "seconds": {s.name: seconds(s) for s in scenes},
    }
