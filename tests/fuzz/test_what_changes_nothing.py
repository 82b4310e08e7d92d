"""What has no effect on a scene changes nothing: a force of nought, a late push, a cart far off.

Each takes another way through the engine than the scene without it (other solvers, other rows).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from copy import deepcopy

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.outcome import UnsolvedError
from sim.scene import read_scene
from tests.fuzz.kinds import scene_of
from tests.fuzz.rows import Plain
from tests.fuzz.verdict import conditioning, distance
from tests.processor_time import TooSlowError, budget

KINDS = ("overlaps", "releases", "touching springs", "instant rows", "friction", "hertz", "chains")
SEEDS = (77000, 77001, 77003)

ALIKE = 1e-11
"""Of the greatest speed and way: what is promised of an end state, beside its conditioning."""

SECONDS = 3.0
"""s of processor time; a run without these takes at most one."""


def with_nothing_more(plain: Plain) -> Iterator[tuple[str, Plain]]:
    """The scene with one thing more that does nothing, by its name."""
    acting = {kind for entry in plain.get("effects", []) for kind in entry}
    late = {"from": plain["until"] + 1, "until": plain["until"] + 2}
    nothing: Plain = {
        "push": {"cart": next(iter(plain["carts"])), "force": 1} | late,
        "incline": {"angle": "0 deg"},
        "friction": {"coefficient": 0},
        "drag": {"linear": 1e-48},
    }
    for kind, body in nothing.items():
        if kind == "push" or kind not in acting:
            yield kind, plain | {"effects": [*plain.get("effects", []), {kind: body}]}
    if plain["track"]["right"] == "open":
        far = deepcopy(plain)
        far["carts"]["far"] = {"mass": 1, "position": 1e6, "velocity": 0}
        far["track"]["length"] = 2e6
        yield "far", far


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", SEEDS)
def test_what_has_no_effect_changes_no_end(kind: str, seed: int) -> None:
    plain = scene_of(kind, seed)
    try:
        with budget(SECONDS):
            done = run(read_scene(plain))
    except (TooSlowError, UnsolvedError):
        pytest.skip("too many steps")
    count, allowed = len(plain["carts"]), -math.inf
    for what, more in with_nothing_more(plain):
        with budget(SECONDS):
            other = run(read_scene(more))
        off = distance(done, other.x[:count], other.v[:count])
        if off > max(ALIKE, allowed):
            allowed = 100.0 * conditioning(plain, done) + ALIKE
        assert off <= max(ALIKE, allowed), what
