"""Inputs with a tolerance: the certificate shows what they allow, the run takes the middle."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from sim.certify.certificate import certify, document
from sim.dynamics.loop.run import run
from sim.scene import SceneError, read_scene


def pair(mass: object = 1, **more: Any) -> dict[str, Any]:
    carts = {
        "A": {"mass": mass, "position": 0, "velocity": 1},
        "B": {"mass": 2, "position": 1},
    }
    return {"carts": carts, "contact": {"law": "instant", "restitution": 0.5}, "until": 2} | more


def test_a_tolerance_shows_what_the_inputs_allow() -> None:
    """v_A' = V − e (V − v_A)…: for m from 0.9 to 1.1 it goes from −0.034 to 0.065."""
    found = document(certify(read_scene(pair("1.0(1) kg"))))
    low, high = map(float, found["final"]["v"]["A"])

    def after(m: float) -> float:
        centre = m / (m + 2)
        return centre + 0.5 * (centre - 1)

    assert low <= after(0.9) and after(1.1) <= high
    assert high - low < 3 * (after(1.1) - after(0.9))
    for m in (0.9, 0.93, 1.0, 1.06, 1.1):
        v = run(read_scene(pair(m))).v[0]
        assert low <= v <= high


@pytest.mark.parametrize(
    "text", ["1.00(5) kg", "1 kg ± 0.05 kg", "1.00 ± 0.05 kg", "1000(50) g", "1000 g ± 50"]
)
def test_a_run_takes_the_middle_and_all_ways_to_write_it_are_one(text: str) -> None:
    scene = read_scene(pair(text))
    assert scene.carts[0].mass == 1.0
    assert scene.tolerances == {"A.mass": Fraction(1, 20)}
    assert run(scene).v == run(read_scene(pair(1))).v
    assert document(certify(scene)) == document(certify(read_scene(pair("1.00(5) kg"))))


def test_places_with_tolerances_widen_times() -> None:
    scene = pair()
    scene["carts"]["B"]["position"] = "1.000(2) m"
    found = document(certify(read_scene(scene)))
    low, high = map(float, found["events"][0]["t"])
    assert (low, high) == pytest.approx((0.798, 0.802), abs=1e-9)


def test_an_order_that_the_inputs_leave_open_is_not_claimed() -> None:
    """C comes from the right: with ± 1 cm nobody knows whom B meets first."""
    carts = {
        "A": {"mass": 1, "position": 0, "velocity": 1},
        "B": {"mass": 1, "position": "1.00(1)"},
        "C": {"mass": 1, "position": 2, "velocity": -1},
    }
    scene = {"carts": carts, "contact": {"law": "instant", "restitution": 0.5}, "until": 2}
    found = document(certify(read_scene(scene)))
    assert found["order"] == "not-provable" and "what comes first" in found["reason"]


@pytest.mark.parametrize(
    ("mass", "code"),
    [
        ("0.5(6) kg", "out-of-range"),
        ("0.5() kg", "wrong-unit"),
        ("0.5 kg ± 1 m", "wrong-unit"),
        ("0.5 kg ± -0.01 kg", "not-a-number"),
    ],
)
def test_a_tolerance_that_makes_no_sense_is_an_error(mass: str, code: str) -> None:
    with pytest.raises(SceneError) as error:
        read_scene(pair(mass))
    assert [(p.path, p.code) for p in error.value.problems] == [(("carts", "A", "mass"), code)]


def test_only_masses_and_lengths_have_a_tolerance() -> None:
    scene = pair()
    scene["carts"]["A"]["velocity"] = "1.0(1) m/s"
    with pytest.raises(SceneError):
        read_scene(scene)
