"""The key of a reading: what the run says with the settings of the page as it opens."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from sim.lesson import Common
from sim.lesson.kinds.run import Reading
from sim.pages.blocks.scene_block import Lesson
from sim.pages.question.as_opened import as_opened
from sim.pages.question.key_page import lesson_key
from sim.scene import read_scene
from tests import registry

FOUND = 1e-7
"""Relative. A cubic through the samples of a contact is right to 1e-8 of the amplitude."""


def reading(quantity: str, at: float | str, unit: str = "", per: float = 1.0) -> Reading:
    """Of any scene."""
    return Reading(
        common=Common(id="one", ask="?"), scene="s", quantity=quantity, at=at,
        unit=unit, units={}, per=per, tolerance=0.01, relative=False,
    )  # fmt: skip


ELASTIC = {"law": "bumper", "restitution": 1, "stiffness": 500}
"""1 kg at 1 m/s runs into 2 kg at −0.5 m/s; mu is 2/3 kg, they close with 1.5 m/s."""


@pytest.mark.parametrize(
    ("quantity", "at", "truth"),
    [
        ("v.A", "start", 1.0),
        ("v.A", "end", -1.0),
        ("p.B", "end", 1.0),
        ("x.A", 0.25, 0.25),
        ("F.A-B", "largest", 1.5 * math.sqrt(500 * 2 / 3)),
        ("F.A-B", 0.41, 1.5 * math.sqrt(500 * 2 / 3) * math.sin(0.01 * math.sqrt(750))),
    ],
)
def test_a_reading_is_what_the_closed_form_of_an_impact_says(
    quantity: str, at: float | str, truth: float
) -> None:
    found = as_opened(reading(quantity, at), read_scene(registry.two_carts(**ELASTIC)))
    assert found == pytest.approx(truth, rel=FOUND)


def test_a_place_on_a_slope_lies_on_the_parabola_and_is_told_in_the_unit_asked_for() -> None:
    plain: dict[str, Any] = {
        "carts": {"A": {"mass": 1, "position": 0, "velocity": "0.3"}},
        "effects": [{"incline": {"angle": "2 deg"}}],
        "until": 2,
    }
    scene = read_scene(plain)
    a = as_opened(reading("a.A", 1.0), scene)
    assert a is not None and abs(a) == pytest.approx(9.81 * math.sin(math.radians(2)), rel=1e-3)
    found = as_opened(reading("x.A", 1.3, "cm", 0.01), scene)
    assert found == pytest.approx(100 * (0.3 * 1.3 + 0.5 * a * 1.3**2), rel=FOUND)


def test_the_farthest_place_of_a_cart_that_turns_round_lies_within_its_flight() -> None:
    """Neither its first place nor its last, and no sample lies there."""
    plain: dict[str, Any] = {
        "carts": {"A": {"mass": 1, "position": "0.2", "velocity": "0.6"}},
        "effects": [{"incline": {"angle": "-2 deg"}}],
        "until": 3,
    }
    top = 0.2 + 0.6**2 / (2 * 9.81 * math.sin(math.radians(2)))
    found = as_opened(reading("x.A", "largest"), read_scene(plain))
    assert found == pytest.approx(top, rel=FOUND)


def test_of_a_cart_that_stops_dead_nothing_is_read_but_nought() -> None:
    """Equal masses, e = 1: rounding leaves some 1e-17 m/s, of which no 2 % is anything."""
    found = as_opened(reading("v.A", "end"), read_scene(registry.two_carts(**ELASTIC)))
    equal = {**ELASTIC, "masses": (0.5, 0.5), "velocities": ("0.6", 0), "until": 3}
    stopped = as_opened(reading("v.A", "end"), read_scene(registry.two_carts(**equal)))
    assert found != 0
    assert stopped == 0


def test_a_pair_that_never_meets_has_no_force_to_read() -> None:
    scene = read_scene(registry.two_carts(velocities=(0, 0), **ELASTIC))
    assert as_opened(reading("F.A-B", "largest"), scene) in (None, 0.0)


def test_the_key_names_the_number_of_the_scene_beside_the_question() -> None:
    text = """# One
```scene
id: hit
carts:
  A: {mass: 1 kg, position: 0 m, velocity: 1 m/s}
  B: {mass: 2 kg, position: 0.8 m, velocity: -0.5 m/s}
contact: {restitution: 1, stiffness: 500 N/m}
until: 1 s
```
```question
id: read
type: reading
ask: How fast is A at the end?
scene: hit
quantity: v.A
unit: cm/s
tolerance: 1 cm/s
```
"""
    key = lesson_key(text, Lesson(str(Path("one.md"))), "one", "tests")
    assert key is not None
    assert "± 1 cm/s (as the page opens: -100 cm/s)" in key.page
