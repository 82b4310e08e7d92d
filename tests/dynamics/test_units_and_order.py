"""No number of the engine is a length, a time or a mass: other units, another order, a mirror."""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.outcome import UnsolvedError
from sim.scene import read_scene
from tests.fuzz.mirror import mirrored
from tests.fuzz.units import scaled

EFFECTS: dict[str, list[dict[str, Any]]] = {
    "none": [],
    "incline": [{"incline": {"angle": "-4 deg"}}],
    "push": [{"push": {"cart": "A", "force": 1.5, "from": 0.1, "until": 0.6}}],
    "spring": [{"spring": {"between": ["A", "B"], "stiffness": 30, "length": 0.1, "damping": 0.5}}],
    "linear drag": [{"drag": {"linear": 0.4}}],
    "driven drag": [{"drag": {"quadratic": 0.7}}, {"incline": {"angle": "2 deg"}}],
    "friction": [{"friction": {"coefficient": 0.02, "static": 0.03}}],
    "magnets": [{"magnets": {"between": ["A", "B"], "strength": 0.002, "power": 2}}],
    "release": [{"release": {"between": ["B", "C"], "energy": 0.4, "at": 0.3}}],
}
LAWS = ("bumper", "paper", "push-only", "push-only-uncorrected", "instant", "velcro")


def scene_with(effects: list[dict[str, Any]], law: str) -> dict[str, Any]:
    contact: dict[str, Any] = {"law": law}
    if law != "velcro":
        contact["restitution"] = 0.6
    if law not in ("instant", "velcro"):
        contact["stiffness"] = 400
    return {
        "carts": {
            "A": {"mass": 1.3, "position": 0.4, "velocity": 0.7},
            "B": {"mass": 0.6, "position": 0.9, "velocity": 0},
            "C": {"mass": 2.1, "position": 1.1, "velocity": 0},
        },
        "track": {"left": "wall", "right": "wall", "length": 1.6},
        "contact": contact,
        "effects": effects,
        "gravity": 9.81,
        "until": 2,
    }


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("what", EFFECTS)
def test_in_units_that_are_powers_of_two_the_run_is_the_same_to_the_last_bit(
    what: str, law: str
) -> None:
    plain = scene_with(EFFECTS[what], law)
    m, length, s = 2.0**-11, 2.0**9, 2.0**-6
    one, two = run(read_scene(plain)), run(read_scene(scaled(plain, m, length, s)))
    assert two.v == tuple(v * length / s for v in one.v)
    assert two.ledger.warmed == one.ledger.warmed * m * length**2 / s**2
    assert [e.t for e in two.record.events] == [e.t * s for e in one.record.events]
    assert two.solvers == one.solvers


@pytest.mark.parametrize(
    ("between", "velocities"), [(["left", "A"], (-10, 0)), (["A", "B"], (10, 0))]
)
def test_magnets_on_points_are_given_up_too(
    between: list[str], velocities: tuple[float, float]
) -> None:
    """Points have no length: what they are apart by at first tells how near is too near."""
    places = {"A": 0.5, "B": 1.0}
    plain = {
        "carts": {
            name: {"mass": 1, "position": places[name], "velocity": v, "length": 0}
            for name, v in zip("AB", velocities, strict=True)
        },
        "track": {"left": "wall", "length": 2},
        "effects": [{"magnets": {"between": between, "strength": 1e-3, "power": 1}}],
        "until": 1,
    }
    with pytest.raises(UnsolvedError, match="nearer than"):
        run(read_scene(plain))


@pytest.mark.parametrize("length", [2.0**-16, 1.0, 2.0**30])
def test_how_near_magnets_can_be_followed_is_a_part_of_the_carts(length: float) -> None:
    """A cart of 0.2 m comes to 0.4 µm, where C/r = ½ m v² holds it; at 0.4 nm it is given up."""
    near, too_near = (
        scaled(
            {
                "carts": {"A": {"mass": 1, "position": 0.4, "velocity": -1}},
                "track": {"left": "wall", "length": 1},
                "contact": {"law": "instant"},
                "effects": [{"magnets": {"between": ["left", "A"], "strength": c, "power": 2}}],
                "until": 1,
            },
            1.0,
            length,
            1.0,
        )
        for c in (2e-7, 2e-10)
    )
    assert run(read_scene(near)).v[0] > 0.0
    with pytest.raises(UnsolvedError, match="nearer than"):
        run(read_scene(too_near))


@pytest.mark.parametrize("what", EFFECTS)
def test_carts_listed_in_another_order_run_alike_to_the_last_bit(what: str) -> None:
    plain = scene_with(EFFECTS[what], "paper")
    other = plain | {"carts": dict(reversed(plain["carts"].items()))}
    one, two = run(read_scene(plain)), run(read_scene(other))
    names = ([cart.name for cart in done.scene.carts] for done in (one, two))
    first, second = (
        dict(zip(own, done.v, strict=True)) for own, done in zip(names, (one, two), strict=True)
    )
    assert first == second


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("what", EFFECTS)
def test_the_mirror_image_of_every_effect_is_the_mirror_image_of_the_run(
    what: str, law: str
) -> None:
    plain = scene_with(EFFECTS[what], law)
    one, two = run(read_scene(plain)), run(read_scene(mirrored(plain)))
    assert [-v for v in reversed(two.v)] == pytest.approx(list(one.v), abs=1e-12)
    assert two.record.counts == one.record.counts
