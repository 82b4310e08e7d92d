"""What a map's request is answered with: the values of the runs, whole or slice by slice."""

from __future__ import annotations

import json
import math
from typing import Any

import pytest

from sim.bridge.protocol import answer
from sim.dynamics.loop.run import run
from sim.scene import SceneError, apply_changes, read_scene
from sim.scene.fence.map import MOST, USUAL, read_map
from sim.scene.said import from_wire
from tests import registry

MAP: dict[str, Any] = {
    **registry.plain("light-meets-heavy"),
    "id": "m",
    "over": [
        {"set": "A.mass", "from": "0.5 kg", "to": "5 kg"},
        {"set": "contact.restitution", "from": 0, "to": 1},
    ],
    "show": "v.B",
}
CHAIN: dict[str, Any] = {
    **registry.plain("triple-hit"),
    "id": "c",
    "over": [{"set": "A.velocity", "from": 0.5, "to": 1.5}],
    "show": "warmed",
    "points": 30,
}


def ask(described: dict[str, Any], **more: Any) -> tuple[dict[str, Any], list[float]]:
    header, numbers = answer({"id": 3, "kind": "map", "map": described, **more})
    json.dumps(header, allow_nan=False)
    return header, list(numbers)


def test_a_map_is_answered_with_the_values_of_single_runs() -> None:
    header, values = ask(MAP, set={"B.mass": 2})
    masses, restitutions = header["axes"]
    assert header["ok"] is True
    assert (header["columns"], header["rows"]) == (len(masses), len(restitutions))
    assert header["runs"] == 0
    for row, column in ((0, 0), (100, 70), (200, 180)):
        changes = {"B.mass": 2, "A.mass": masses[column], "contact.restitution": restitutions[row]}
        single = run(read_scene(apply_changes(registry.plain("light-meets-heavy"), changes)))
        value = values[row * len(masses) + column]
        assert math.isclose(value, single.v[1], rel_tol=1e-14)


def test_runs_come_in_slices_that_make_up_the_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sim.bridge.map_answer.SLICE", 1e9)
    header, whole = ask(CHAIN)
    assert header["done"] == header["runs"] == 30
    monkeypatch.setattr("sim.bridge.map_answer.SLICE", 0.0)
    header, values = ask(CHAIN)
    assert header["done"] == 1
    assert [math.isnan(value) for value in values] == [False] + [True] * 29
    while header["done"] < header["runs"]:
        header, slice_ = ask(CHAIN, **{"from": header["done"]})
        half = len(slice_) // 2
        for place, value in zip(slice_[:half], slice_[half:], strict=True):
            values[int(place)] = value
    assert values == whole
    assert "each of the 30 points is a run of its own" in from_wire(header["why"])


def test_what_a_reader_types_is_refused_with_a_reason() -> None:
    header, values = ask(MAP, set={"B.mass": -1})
    assert header["ok"] is False
    assert header["problems"][0]["path"] == ["carts", "B", "mass"]
    assert values == []
    for wrong in ({}, {"map": None}, {"map": {"carts": 3}}, {"map": MAP, "set": {"C.mass": 1}}):
        assert answer({"id": 1, "kind": "map", **wrong})[0]["ok"] is False


def test_a_map_left_to_itself_has_about_200_points_with_a_round_step() -> None:
    for low, high, step in (("0.5 kg", "5 kg", 0.025), (0.1, 2, 0.01), ("100 g", "1 kg", 0.005)):
        over = [{"set": "A.mass", "from": low, "to": high}]
        (values,) = read_map({**MAP, "over": over}).values
        assert 150 <= len(values) <= 251
        assert values[1] - values[0] == pytest.approx(step)
        assert values[1] == float(f"{values[1]:.12g}")  # decimals, rounded once
    (values,) = read_map({**MAP, "over": [{"set": "A.mass", "from": 0.3, "to": 3.017}]}).values
    assert len(values) == USUAL
    for points in (2, 17, str(MOST)):
        (values,) = read_map({**MAP, "over": over, "points": points}).values
        assert (len(values), values[0], values[-1]) == (int(points), 0.1, 1.0)


def test_an_axis_without_a_unit_beside_one_in_grams_is_refused() -> None:
    with pytest.raises(SceneError) as caught:
        read_map({**MAP, "over": [{"set": "A.mass", "from": "100 g", "to": 900}]})
    (problem,) = caught.value.problems
    assert (problem.where, problem.code) == ("over.0.to", "wrong-unit")


def test_every_mistake_of_a_map_is_told_at_once() -> None:
    twice = [{"set": "A.mass", "from": 0.1, "to": 2}] * 2
    wrong = {**MAP, "over": twice, "show": "p", "points": 1}
    with pytest.raises(SceneError) as caught:
        read_map(wrong)
    codes = [problem.code for problem in caught.value.problems]
    assert set(codes) == {"out-of-range", "twice", "not-a-choice"}
    assert all(problem.hint for problem in caught.value.problems)
