"""Releases by every stepping method: at their time, and with the outcome of the exact run."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.stepping.methods import ADAPTIVE, FIXED, MethodChoice
from sim.dynamics.stepping.recorded import SteppedRun, stepped
from sim.scene import Scene, read_scene
from tests import registry

WITH_RELEASE = [
    name
    for name in registry.NAMES
    if any(effect.kind == "release" for effect in registry.scene(name).effects)
]
LOCATED = ("rk4-events", *ADAPTIVE)
DIVERGES = {"euler"}
"""It makes energy in every stiff contact: see `test_stepping`."""


def way(method: str, scene: Scene) -> MethodChoice:
    """3001 steps, or a tolerance."""
    return (
        MethodChoice(method, rtol=1e-9)
        if method in ADAPTIVE
        else MethodChoice(method, step=scene.until / 3001)
    )


def exploded(**more: Any) -> Scene:
    """0.5 kg and 1 kg touch at rest; 0.06 J are set free at t = 0, the default of a release."""
    release = {"release": {"between": ["A", "B"], "energy": "0.06", **more}}
    return read_scene(
        {
            "carts": {"A": {"mass": "0.5", "position": 1}, "B": {"mass": 1, "position": "1.2"}},
            "effects": [release],
            "until": 1,
        }
    )


def times(done: SteppedRun) -> list[float]:
    return [event.t for event in done.run.record.events if event.kind == "release"]


@pytest.mark.parametrize("method", LOCATED)
def test_a_release_at_the_start_happens_at_the_start(method: str) -> None:
    """From rest m v = sqrt(2 E mu) = 0.2 N s on each: −0.4 m/s and 0.2 m/s, for one second."""
    for asked in (MethodChoice(method, step=0.1), MethodChoice(method, step=0.3)):
        done = stepped(exploded(), MethodChoice(method, rtol=1e-9) if method in ADAPTIVE else asked)
        assert done.run.x == pytest.approx((0.6, 1.4), abs=1e-12)
        assert times(done) == [0.0]
        assert abs(done.lost_energy) < 1e-12
        assert abs(done.lost_momentum) < 1e-12


@pytest.mark.parametrize("method", sorted({*FIXED} - {"yoshida"}))  # it steps back, into B
def test_carts_that_part_in_the_first_step_are_released_before_it(method: str) -> None:
    """A rests and touches B, which leaves at 1 m/s: relative 1 m/s → sqrt(1 + 2 E/mu) at once."""
    scene = read_scene(
        {
            "carts": {
                "A": {"mass": "0.5", "position": 1},
                "B": {"mass": 1, "position": "1.2", "velocity": 1},
            },
            "effects": [{"release": {"between": ["A", "B"], "energy": "0.06"}}],
            "until": 1,
        }
    )
    done = stepped(scene, MethodChoice(method, step=0.1))
    assert done.run.v == pytest.approx(run(scene).v, abs=1e-12)
    assert times(done) == [0.0]
    assert abs(done.lost_energy) < 1e-12


@pytest.mark.parametrize("method", LOCATED)
@pytest.mark.parametrize("at", [0.1, 0.3, 0.7, 1.0])
def test_a_release_is_told_at_its_own_time_and_never_left_out(method: str, at: float) -> None:
    """Also where it comes in the middle of a step, and at the end of the run."""
    scene = exploded(at=at)
    done = stepped(
        scene,
        MethodChoice(method, rtol=1e-9) if method in ADAPTIVE else MethodChoice(method, step=0.17),
    )
    assert times(done) == [pytest.approx(at, abs=1e-15)]
    assert done.run.x == pytest.approx((1 - 0.4 * (1 - at), 1.2 + 0.2 * (1 - at)), abs=1e-12)
    assert done.run.ledger.works["release"] == pytest.approx(0.06, abs=1e-15)
    assert abs(done.lost_energy) < 1e-12


@pytest.mark.parametrize("method", sorted({*FIXED, *LOCATED} - DIVERGES))
@pytest.mark.parametrize("name", WITH_RELEASE)
def test_every_stepper_comes_to_the_exact_run(name: str, method: str) -> None:
    scene = registry.scene(name)
    true, done = run(scene), stepped(scene, way(method, scene))
    step = 0.0 if method in LOCATED else scene.until / 3001
    near = 1e-4 if method in LOCATED else 10.0 * step
    scale = max(1.0, *map(abs, true.v))
    assert done.run.x == pytest.approx(true.x, abs=near * scale)
    assert done.run.v == pytest.approx(true.v, abs=near * scale)
    told = [event.t for event in true.record.events if event.kind == "release"]
    assert len(times(done)) == len(told)
    for exact, late in zip(told, times(done), strict=True):
        assert -1e-12 <= late - exact <= step + 1e-12
    assert math.isfinite(done.lost_energy)
