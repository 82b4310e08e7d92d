"""What “How is this computed?” is answered with."""

from __future__ import annotations

import json
import subprocess
import sys
from typing import Any

import pytest

from sim.bridge.protocol import answer
from sim.scene.said import from_wire
from tests import registry
from tests.web.scene.given.widget_site import in_node

FIXED = ["euler", "semi-implicit", "verlet", "yoshida", "richardson", "rk4", "rk4-events"]


def ask(name: str, **more: Any) -> tuple[dict[str, Any], dict[tuple[str, ...], list[float]]]:
    request = {"id": 4, "kind": "how", "scene": registry.plain(name), **more}
    header, numbers = answer(request)
    json.dumps(header, allow_nan=False)
    rows = header.get("rows", 0)
    columns = {
        tuple(column): list(numbers[k * rows : (k + 1) * rows])
        for k, column in enumerate(header.get("columns", []))
    }
    return header, columns


def test_a_page_that_asks_for_runs_never_loads_a_stepping_method() -> None:
    code = (
        "import sys, json; from sim.bridge.protocol import answer; from tests import registry\n"
        "answer({'id': 1, 'kind': 'run', 'scene': registry.plain('touching-row')})\n"
        "print(json.dumps([name for name in sys.modules if 'stepping' in name or 'how_' in name]))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) == []


def test_the_cost_is_that_of_the_solution_and_of_the_points() -> None:
    header, _ = ask("paper-two-carts")
    assert header["ok"] and set(header["cost"]) == {"solution", "points"}
    assert all(0.0 < value < 1.0 for value in header["cost"].values())


@pytest.mark.parametrize("method", FIXED)
@pytest.mark.parametrize("name", ["paper-two-carts", "off-the-wall", "instant", "incline-bounce"])
def test_errors_are_what_lies_between_the_stepped_run_and_the_exact_one(
    name: str, method: str
) -> None:
    exact, _ = answer({"id": 1, "kind": "run", "scene": registry.plain(name)})
    header, columns = ask(name, method=method, parts=499)
    how = header["how"]
    for kind in ("x", "v"):
        last = {body: columns[kind, body][-1] for body in exact["final"][kind]}
        far = max(abs(last[body] - true) for body, true in exact["final"][kind].items())
        assert how["error"][kind] == pytest.approx(far, abs=1e-15)
    assert how["steps"] == 499
    assert how["evaluations"] >= 499
    assert header["plan"][0]["solver"] == method


@pytest.mark.parametrize("name", ["paper-two-carts", "friction-and-bumper"])
def test_within_a_step_the_drawn_velocity_changes_evenly(name: str) -> None:
    _, columns = ask(name, method="verlet", parts=211)
    times = columns["t",]
    body = next(key[1] for key in columns if key[0] == "v")
    v, a = columns["v", body], columns["a", body]
    for k in range(0, len(times), 2):
        step = times[k + 1] - times[k]
        assert v[k + 1] - v[k] == pytest.approx(a[k] * step, abs=1e-12)
        assert a[k] == a[k + 1]
    assert all(times[k] == times[k + 1] for k in range(1, len(times) - 1, 2))


def test_a_run_that_blows_up_is_drawn_as_far_as_there_is_something_to_see() -> None:
    header, columns = ask("stiff-and-soft", method="euler", parts=103)
    blown = header["how"]["blown"]
    assert 0.0 < blown < header["until"]
    assert columns["t",][-1] < blown
    assert all(event["t"] < blown for event in header["events"])
    assert max(map(abs, columns["v", "A"])) < 100


def test_warnings_are_those_of_the_exact_run() -> None:
    for name in ("stiff-and-soft", "too-soft-bumpers"):
        exact, _ = answer({"id": 1, "kind": "run", "scene": registry.plain(name)})
        header, _ = ask(name, method="euler", parts=103)
        assert header["warnings"] == exact["warnings"]
    assert exact["warnings"]


def test_forces_of_effects_are_drawn_too() -> None:
    _, columns = ask("incline-bounce", method="rk4", parts=499)
    assert min(columns["E", "incline", "A"]) > 0.0


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"method": "magic"}, "no such method"),
        ({"method": "euler"}, "no such number of steps"),
        ({"method": "euler", "parts": 10**9}, "no such number of steps"),
        ({"method": "euler", "parts": 103, "set": {"A.mass": -1}}, "mass"),
    ],
)
def test_what_makes_no_sense_is_refused(more: dict[str, Any], said: str) -> None:
    header, _ = ask("paper-two-carts", **more)
    assert not header["ok"]
    assert said in json.dumps(header["problems"])


def test_numbers_beyond_all_bounds_are_a_sentence() -> None:
    header, _ = ask("hertz-cradle", method="euler", parts=103)
    assert not header["ok"]
    assert from_wire(header["problems"][0]["hint"]) == "a shorter step"


@pytest.mark.parametrize("method", [*FIXED, "rk45"])
@pytest.mark.parametrize(
    "effects", [[], [{"drag": {"linear": 5000}}], [{"drag": {"quadratic": 5}}]]
)
@pytest.mark.parametrize("kind", ["how", "cost"])
def test_a_method_that_blows_up_is_answered_and_never_raised(
    kind: str, effects: list[dict[str, Any]], method: str
) -> None:
    """A stiffness of 1e8 N/m in 500 steps of 20 ms: some methods end beyond all numbers."""
    scene = {
        "carts": {
            "A": {"mass": 1, "position": 0.4, "velocity": 1},
            "B": {"mass": 1, "position": 1.2, "velocity": -0.5},
        },
        "contact": {"law": "bumper", "restitution": 0.9, "stiffness": 1e8},
        "effects": effects,
        "until": 10,
    }
    request = {"id": 1, "kind": kind, "scene": scene, "method": method, "parts": 500, "rtol": 0.01}
    header, _ = answer(request)
    json.dumps(header, allow_nan=False)
    if not header["ok"]:
        [problem] = header["problems"]
        assert problem["code"] == "unsolved"
        assert from_wire(problem["message"]).startswith("the numbers of this method grow")


def test_every_answer_has_good_words() -> None:
    answers = [
        ask(name, method=method, parts=parts)[0]
        for name in ("paper-two-carts", "stiff-and-soft", "push-a-train", "slow-and-long")
        for method, parts in (("euler", 19), ("rk4-events", 211))
    ]
    told = [one["how"] for one in answers]
    none = {"error": {"v": None, "x": None}, "energy": {"made": None, "initial": 0.0}}
    told += [
        {**told[0], **none, "blown": 0.25},
        {**told[0], **none, "whole": False},
        {**told[0], "rtol": 1e-6, "step": None, "method": "rk45"},
    ]
    costs = [ask("paper-two-carts")[0], {"cost": {"solution": 2.5, "points": 3e-7}}]
    lines = in_node(
        "const words = await import(`${source}/scene/how/words.js`);\n"
        "const told = (how) => [words.signWords(how), ...words.comparedWords(how).flat()];\n"
        "give([\n"
        "  ...data.told.flatMap(told),\n"
        "  ...data.costs.map(words.costWords),\n"
        "  words.formulasWords({ 'free-flight': 2, another: 1 }),\n"
        "]);",
        {"told": told, "costs": costs},
    )
    assert not any(word in line for line in lines for word in ("NaN", "undefined", "null", "[obj"))
    assert "free flights: 2, another: 1" in lines[-1]
    assert lines[-2].startswith("On this computer, just now: 2.5 s, of which 2.5 s for the motion")
    assert lines.count("beyond all numbers") == 4
    assert sum(line.startswith("not known") for line in lines) == 2
