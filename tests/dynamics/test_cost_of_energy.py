"""The error of the energy in the table of costs is a part of what there is, with its sign."""

from __future__ import annotations

from typing import Any

import pytest

from sim.dynamics.cost.exact import exact
from sim.dynamics.cost.measure import row
from sim.dynamics.stepping.methods import MethodChoice
from sim.scene import read_scene
from tests.web.scene.given.widget_site import in_node


def two(velocity: float, effect: dict[str, Any], until: float = 2.0, room: float = 1.0) -> Any:
    carts = {
        "A": {"mass": 1, "position": 0.5, "velocity": velocity},
        "B": {"mass": 1, "position": 0.5 + room},
    }
    return read_scene({"carts": carts, "effects": [effect], "until": until})


PUSH = {"push": {"cart": "A", "force": 20, "until": 1}}
MAGNETS = {"magnets": {"between": ["A", "B"], "power": 1, "strength": 2}}


@pytest.mark.parametrize("velocity", [0.0, 0.001])
def test_what_a_push_brings_in_is_what_its_error_is_a_part_of(velocity: float) -> None:
    """Of what there was at the start it was nothing, or ten million times as much."""
    scene = two(velocity, PUSH)
    truth = exact(scene)
    found = row(scene, truth, MethodChoice("euler", step=scene.until / 103))
    assert truth.energy > 100.0
    assert found.energy_error is not None and abs(found.energy_error) < 1.0


def test_a_method_that_ends_with_more_energy_errs_above_nought_whatever_the_sign_of_it() -> None:
    """With n = 1 the energy of magnets that are far apart is below nought."""
    scene = two(1.0, MAGNETS, until=4.0, room=3.0)
    truth = exact(scene)
    found = row(scene, truth, MethodChoice("euler", step=scene.until / 103))
    assert truth.initial < 0.0
    assert found.energy_error is not None and found.energy_error > 0.0


@pytest.mark.parametrize(
    ("initial", "exactly", "told"),
    [
        (2.0, 1.0, ["energy at the end, of that at the start", "60.0 %", "50.0 %"]),
        (0.0, 109.9, ["energy at the end", "1.200 J", "109.900 J"]),
        (-1.7, -1.5, ["energy at the end", "1.200 J", "−1.500 J"]),
    ],
)
def test_energies_are_told_in_joules_where_the_start_had_none_to_speak_of(
    initial: float, exactly: float, told: list[str]
) -> None:
    energy = {"initial": initial, "stepped": 1.2, "exact": exactly, "imbalance": 0.0}
    header = {"v": {"stepped": {}, "exact": {}}, "energy": energy, "evaluations": 1}
    body = "const { told } = await import(`${view}/cost/words.js`); give(told(data)[0]);"
    assert in_node(body, header) == told


@pytest.mark.parametrize(
    ("exactly", "measure"),
    [
        ([2.0, 1.0, 3.0], {"whole": 2.0, "unit": "%", "ticked": 100}),
        ([0.0, 60.0, 110.0], {"whole": 110.0, "unit": "J", "ticked": 110.0}),
        ([0.0, 0.0], {"whole": 1, "unit": "J", "ticked": 1}),
    ],
)
def test_so_does_the_graph_of_the_energy(exactly: list[float], measure: dict[str, Any]) -> None:
    """Of a push from rest nearly all of the curve was cut off, at three times nothing."""
    body = "const { measureOf } = await import(`${source}/cost/stage.js`); give(measureOf(data));"
    assert in_node(body, exactly) == measure
