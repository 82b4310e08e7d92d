"""The map of where methods break: the file is what comes out, and theory draws the border."""

from __future__ import annotations

import json
from typing import Any

import pytest

from sim.dynamics.cost.breaks import MAPS, SIDE, letter, lines, parts, scene_at
from sim.dynamics.cost.exact import exact
from sim.dynamics.stepping.methods import FIXED, MethodChoice
from sim.pages.cost.render import BREAKS
from sim.scene import read_scene

KEPT: dict[str, Any] = json.loads(BREAKS.read_text(encoding="utf-8"))
FEW = [(3, 20), (12, 12), (20, 4)]
"""Columns and rows that are computed again: coarse steps, so that it takes no time."""


def kept(name: str, method: str, column: int, row: int) -> str:
    (found,) = (one for one in KEPT["maps"] if one["name"] == name)
    return str(found["letters"][method][column * SIDE + row])


def test_the_file_is_that_of_these_maps() -> None:
    assert KEPT["parts"] == parts()
    for one, found in zip(MAPS, KEPT["maps"], strict=True):
        assert (one.name, one.values()) == (found["name"], found["values"])
        assert {k: pytest.approx(row, rel=5e-3) for k, row in lines(one).items()} == found["lines"]
        assert set(found["letters"]) == set(FIXED)
        assert {len(letters) for letters in found["letters"].values()} == {SIDE * SIDE}


@pytest.mark.parametrize("one", MAPS, ids=lambda one: one.name)
@pytest.mark.parametrize("method", FIXED)
def test_a_point_comes_out_as_the_file_says(one: Any, method: str) -> None:
    for column, row in FEW:
        scene = read_scene(scene_at(one, one.values()[column]))
        way = MethodChoice(method, step=scene.until / parts()[row])
        assert letter(scene, exact(scene), way) == kept(one.name, method, column, row)


@pytest.mark.parametrize("method", sorted(KEPT["limits"]))
def test_far_beyond_its_limit_no_method_is_right_to_a_digit(method: str) -> None:
    # With little restitution a whole digit is right by itself: there is little to come out.
    for found in KEPT["maps"][:2]:
        for column, swing in enumerate(found["lines"]["swing"]):
            for row, count in enumerate(parts()):
                if 1 / count > 3 * KEPT["limits"][method] * swing:
                    assert kept(found["name"], method, column, row) in "0x"


def test_with_the_shortest_steps_a_soft_contact_is_right_to_two_digits_but_not_by_euler() -> None:
    for method in FIXED:
        digits = {kept("stiffness", method, column, 0) for column in range(4)}
        assert digits <= (set("01x") if method == "euler" else set("2345678")), method
