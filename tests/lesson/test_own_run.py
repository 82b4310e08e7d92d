"""“Read it off the run”: the page reads the same numbers as the run itself has."""

from __future__ import annotations

import json
from typing import Any

import pytest

from sim.bridge.protocol import answer
from sim.lesson import read_question
from tests.web.scene.given.widget_site import MEETING, in_node

SCRIPT = """const { fromWire } = await import(source + "/../../view/trajectory.js");
const { reading } = await import(source + "/question/marking/own-run.js");
const run = fromWire(data.header, Float64Array.from(data.numbers));
give(data.asked.map(([quantity, at]) => reading(run, { A: 0.5, B: 1 }, quantity, at)));"""


def read(asked: list[list[Any]]) -> list[float | None]:
    scene = {key: value for key, value in MEETING.items() if key not in ("id", "controls")}
    header, numbers = answer({"id": 0, "kind": "run", "scene": scene})
    data = {"header": header, "numbers": list(numbers), "asked": asked}
    return list(in_node(SCRIPT, data))


def test_a_reading_is_what_the_run_says() -> None:
    """One contact of two carts: 0.5 kg with 0.60 m/s, 1 kg at rest, e = 0.8, k = 400 N/m."""
    v_a, v_b = -0.12, 0.36  # m/s, by momentum and e
    peak = 0.6 * (400 * (0.5 * 1 / 1.5)) ** 0.5  # N: u √(k μ)
    found = read(
        [["v.A", "start"], ["x.A", 0.5], ["v.A", 2], ["v.B", 2], ["p.A", 2], ["p.B", 2],
         ["F.A-B", "largest"], ["F.A-B", 0.1], ["v.C", "end"], ["F.B-A", 1]]
    )  # fmt: skip
    expected = [0.6, 0.7, v_a, v_b, 0.5 * v_a, v_b, peak, 0.0, None, None]
    for value, right in zip(found, expected, strict=True):
        if right is None:
            assert value is None
        else:
            assert value is not None
            assert abs(value) == pytest.approx(abs(right), rel=1e-4, abs=1e-9)
    assert found[2] == pytest.approx(v_a, rel=1e-6)


def test_what_rounding_leaves_of_a_cart_that_stops_dead_is_nought_and_nothing_else_is() -> None:
    script = """const { reading } = await import(source + "/question/marking/own-run.js");
give(data.map((left) => reading({ t: [0, 1], v: { A: [0.6, left] } }, { A: 1 }, "v.A", "end")));"""
    assert in_node(script, [1e-17, -5e-13, 1e-11, -0.1]) == [0, 0, 1e-11, -0.1]


KEPT = """
const listeners = {};
const scene = { trajectory: null, querySelector: () => ({ textContent: data.baked }) };
globalThis.Element = Object;
const addEventListener = (kind, act) => { listeners[kind.replace("carts-", "")] = act; };
globalThis.document = { getElementById: () => scene, addEventListener };
const { fromWire } = await import(source + "/../../view/trajectory.js");
const { readOff } = await import(source + "/question/forms/run.js");
const facts = { scene: "meeting", quantity: "v.A", at: 2, per: 1 };
const earlier = { own: 9, set: { "A.mass": 9 }, value: "0.2" };
const none = readOff(facts, { ...earlier });
scene.trajectory = fromWire(data.header, Float64Array.from(data.numbers));
listeners.update({ target: scene, detail: { "A.mass": 5 } });
const now = readOff(facts, { ...earlier });
listeners.reset({ target: scene });
give({ none, now, reset: readOff({ ...facts, quantity: "p.A" }, {}) });
"""


def test_a_number_goes_with_the_run_that_is_on_the_screen_and_with_no_earlier_one() -> None:
    scene = {key: value for key, value in MEETING.items() if key not in ("id", "controls")}
    header, numbers = answer({"id": 0, "kind": "run", "scene": scene})
    found = in_node(KEPT, {"header": header, "numbers": list(numbers)})
    assert found["none"] == {"value": "0.2"}
    assert found["now"]["own"] == pytest.approx(-0.12, rel=1e-6)
    assert found["now"]["set"] == {"A.mass": 5}


def test_after_all_values_were_reset_a_reading_knows_none_of_them() -> None:
    scene = {key: value for key, value in MEETING.items() if key not in ("id", "controls")}
    header, numbers = answer({"id": 0, "kind": "run", "scene": scene})
    baked = json.dumps({"bodies": header["bodies"]})
    found = in_node(KEPT, {"header": header, "numbers": list(numbers), "baked": baked})
    assert found["reset"]["set"] == {}
    assert found["reset"]["own"] == pytest.approx(0.5 * -0.12, rel=1e-6)  # kg m/s, not of 5 kg


@pytest.mark.parametrize(
    ("at", "meant"), [("2 s", 2.0), ("0 s", 0.0), ("-1 s", 0.0), ("end", "end")]
)
def test_a_moment_before_the_run_is_its_start(at: str, meant: float | str) -> None:
    asked = {"id": "r", "type": "reading", "ask": "?", "scene": "meeting", "quantity": "v.A"}
    facts = read_question({**asked, "at": at, "tolerance": "0.01 m/s"}).data(key=True)
    assert facts["at"] == meant
