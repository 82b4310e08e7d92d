"""Two with magnets never touch: where they are nearest is an event, with their greatest force.

For n = 3 and nobody else r² = r0² + 2 r0 w t + (2 E/mu) t², E all energy between the two, w = r0'.
"""

from __future__ import annotations

import itertools
import math
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.events import Event
from sim.dynamics.result.trajectory import trajectory
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.recorded import stepped
from sim.scene import read_scene

FOUND = 1e-12
"""m, m/s, s, relative for N: the root of a polynomial in one step of a power series."""

STEPPED = {"rk4-events": 1e-8, "adaptive": 1e-7, "rk45": 1e-7}
"""s and relative for N; these locate it. The others say when a step ended: 1e-3 s."""


def scene(c: float = 3e-4, speed: float = 0.5, **more: Any) -> dict[str, Any]:
    return {
        "carts": {
            "A": {"mass": 0.5, "position": 0.4, "velocity": speed},
            "B": {"mass": 1.5, "position": 1.2},
        },
        "effects": [{"magnets": {"between": ["A", "B"], "strength": c}}],
        "until": 4,
    } | more


def peaks(plain: dict[str, Any]) -> list[Event]:
    return [event for event in run(read_scene(plain)).record.events if event.kind == "peak"]


@pytest.mark.parametrize("c", [1e-6, 3e-4, 2e-2])
@pytest.mark.parametrize("speed", [0.3, 0.5, 2.0])
def test_magnets_are_nearest_where_the_closed_form_turns(c: float, speed: float) -> None:
    (peak,) = peaks(scene(c, speed))
    mu, r0, w = 0.375, 0.6, -speed
    energy = 0.5 * mu * w * w + 0.5 * c / r0**2
    turn = -r0 * w * mu / (2 * energy)
    nearest = math.sqrt(r0**2 - (r0 * w) ** 2 * mu / (2 * energy))
    assert peak.bodies == ("A", "B")
    assert peak.t == pytest.approx(turn, abs=FOUND)
    assert peak.force == pytest.approx(c / nearest**3, rel=1e-10)
    assert peak.after == peak.before
    assert peak.after["A"] == pytest.approx(peak.after["B"], abs=FOUND)
    assert peak.impulse == 0.0


@pytest.mark.parametrize(("power", "c"), [(1, 0.02), (2, 3e-4), (2.5, 3e-4), (4, 3e-4)])
def test_no_sample_of_the_force_is_greater(power: float, c: float) -> None:
    plain = scene(c)
    plain["effects"][0]["magnets"] |= {"power": power}
    (peak,) = peaks(plain)
    samples = trajectory(run(read_scene(plain))).columns[("F", "A-B")]
    assert peak.force is not None
    assert max(samples) == pytest.approx(peak.force, rel=1e-9)


def test_magnets_that_are_let_go_only_part() -> None:
    assert peaks(scene(speed=0.0)) == []


def test_a_cart_on_a_slope_turns_at_the_wall_again_and_again() -> None:
    """Downhill towards a magnet at the wall: one event for each turn, none at the top."""
    plain = {
        "carts": {"A": {"mass": 0.5, "position": 0.6}},
        "track": {"left": "wall"},
        "effects": [
            {"incline": {"angle": "-2 deg"}},
            {"magnets": {"between": ["left", "A"], "strength": 1e-4}},
        ],
        "until": 20,
    }
    found = peaks(plain)
    assert len(found) > 5
    periods = [b.t - a.t for a, b in itertools.pairwise(found)]
    assert periods == pytest.approx([periods[0]] * len(periods), abs=1e-9)
    assert found[0].bodies == ("left", "A")


def test_a_cart_that_comes_to_rest_before_a_magnet_tells_no_endless_story() -> None:
    """With drag the swings fade; what rounding leaves of them is no approach."""
    plain = {
        "carts": {"A": {"mass": 0.5, "position": 0.6}},
        "track": {"left": "wall"},
        "effects": [
            {"incline": {"angle": "-2 deg"}},
            {"drag": {"linear": 0.8}},
            {"magnets": {"between": ["left", "A"], "strength": 1e-4}},
        ],
        "until": 60,
    }
    assert len(peaks(plain)) < 60


@pytest.mark.parametrize("method", ["euler", "verlet", "rk4", *STEPPED])
def test_stepping_methods_tell_it_too(method: str) -> None:
    plain = scene()
    (exact,) = peaks(plain)
    way = (
        MethodChoice(method, rtol=1e-9)
        if method in ("adaptive", "rk45")
        else MethodChoice(method, step=1e-3)
    )
    done = stepped(read_scene(plain), way).run
    (told,) = [event for event in done.record.events if event.kind == "peak"]
    near = STEPPED.get(method, 2e-3)
    assert told.t == pytest.approx(exact.t, abs=near)
    assert told.force == pytest.approx(
        exact.force, rel=max(near, 2e-2 if method == "euler" else 1e-3)
    )
