"""Runs prepared for sliders: which values, each the run that Python would give, and how many."""

from __future__ import annotations

import base64
import gzip
import itertools
import json
import re
import struct
from collections.abc import Mapping
from html import unescape
from typing import Any

import pytest

from sim.bridge.protocol import answer
from sim.pages.blocks.bake import Run, bake
from sim.pages.blocks.makers import Page, made
from sim.pages.blocks.scene_block import Lesson
from sim.pages.prepared import MOST_BYTES, Prepared, grid_of, prepare
from sim.pages.text.fence_scan import scan
from sim.scene import Fence, read_fence

SLIDERS = [
    {"set": "A.mass", "from": "0.5 kg", "to": "3 kg", "step": "0.25 kg"},
    {"set": "A.velocity", "from": "0 km/h", "to": "5 km/h", "step": "0.5 km/h"},
    {"set": "contact.restitution", "from": 0, "to": 1, "step": 0.1},
    {"set": "B.mass", "from": "0.5 kg", "to": "1.5 kg", "step": "0.5 kg"},
    {"set": "friction.coefficient", "from": 0, "to": 0.1, "step": 0.01},
]
COUNTS = range(len(SLIDERS) + 1)


def fence(sliders: int = 2, **more: Any) -> Fence:
    return read_fence(
        {
            "id": "meeting",
            "carts": {
                "A": {"mass": "1 kg", "position": "0.3 m", "velocity": "2 km/h"},
                "B": {"mass": "1 kg", "position": "1 m"},
            },
            "contact": {"law": "instant", "restitution": "0.5"},
            "effects": [{"friction": {"coefficient": 0.02}}],
            "controls": SLIDERS[:sliders],
            "until": "3 s",
            **more,
        }
    )


def prepared(scene: Fence) -> Prepared:
    run = bake(scene.plain)
    assert isinstance(run, Run)
    found = prepare(scene, run)
    assert found is not None
    return found


def table(found: Prepared) -> tuple[dict[str, Any], list[float]]:
    """What a page reads from the scripts, by the description of the format alone."""
    texts = [re.search(r'="([^"]*)"', found.scripts[part["src"]]) for part in found.parts]
    data = gzip.decompress(b"".join(base64.b64decode(text[1]) for text in texts if text))
    (length,) = struct.unpack_from("<Q", data)
    numbers = [x for (x,) in struct.iter_unpack("<d", data[8 + length :])]
    return json.loads(data[8 : 8 + length]), numbers


@pytest.mark.parametrize("sliders", COUNTS)
def test_every_value_is_one_that_the_slider_can_take(sliders: int) -> None:
    scene = fence(sliders, predict={"choice": ["it stops", "it goes on"]})
    grid = grid_of(scene, 243)
    assert grid is not None
    for axis, control in zip(grid.axes, scene.controls, strict=True):
        steps = [(number - control.low) / control.step for number in axis.numbers]
        assert all(abs(step - round(step)) < 1e-9 for step in steps)
        assert axis.numbers[0] == pytest.approx(control.low, abs=1e-12)
        assert axis.numbers[-1] == pytest.approx(control.high)
        assert any(number == pytest.approx(control.value) for number in axis.numbers)


@pytest.mark.parametrize(("sliders", "most"), list(itertools.product(COUNTS, [1, 9, 32, 100, 243])))
def test_there_are_never_more_runs_than_were_allowed(sliders: int, most: int) -> None:
    grid = grid_of(fence(sliders, predict={"choice": ["it stops", "it goes on"]}), most)
    if grid is None:
        assert 3**sliders > most
    else:
        assert len(list(grid.settings())) <= most


def test_each_prepared_run_is_the_one_that_python_gives_for_the_same_request() -> None:
    scene = fence(2)
    told, numbers = table(prepared(scene))
    place = 0
    for values, header in zip(
        itertools.product(*(axis["values"] for axis in told["axes"])), told["headers"], strict=True
    ):
        changes = dict(zip(("A.mass", "A.velocity"), values, strict=True))
        wanted, exact = answer({"id": 0, "kind": "run", "scene": scene.plain, "set": changes})
        assert header["events"] == json.loads(json.dumps(wanted["events"]))
        assert header["final"] == wanted["final"]
        size = header["rows"] * len(header["columns"])
        if header["rows"] == wanted["rows"]:
            assert numbers[place : place + size] == list(exact)
        place += size
    assert place == len(numbers)


def test_boxes_to_tick_double_the_runs_and_presets_are_runs_of_their_own() -> None:
    boxes: list[Mapping[str, Any]] = [*SLIDERS[:1], {"switch": "friction"}]
    scene = fence(controls=boxes, presets={"heavy": {"A.mass": "2.9 kg"}})
    told, _ = table(prepared(scene))
    masses, boxes_values = (axis["values"] for axis in told["axes"])
    assert boxes_values == [False, True]
    assert told["presets"] == [{"A.mass": "2.9 kg"}]
    assert len(told["headers"]) == 2 * len(masses) + 1
    assert told["headers"][-1]["bodies"][0]["mass"] == 2.9


def test_values_that_make_no_run_are_prepared_as_what_is_wrong_with_them() -> None:
    towards = {"set": "A.position", "from": "0.3 m", "to": "1.2 m", "step": "0.3 m"}
    told, _ = table(prepared(fence(controls=[towards])))
    assert [header["ok"] for header in told["headers"]] == [True, True, False, True]
    assert told["headers"][2]["problems"]  # at 0.9 m A would stand in B


@pytest.mark.parametrize("carts", [2, 4])
def test_a_scene_gets_as_many_runs_as_fit(carts: int) -> None:
    row = {f"C{k}": {"mass": 1 + k % 3, "position": f"{0.25 * k + 0.2:.2f}"} for k in range(carts)}
    row["C0"]["velocity"] = 1
    crowd = {
        "id": "row",
        "carts": row,
        "track": {"length": 4, "left": "wall", "right": "wall"},
        "until": 5,
        "controls": [
            {"set": "C0.velocity", "from": 0, "to": 2, "step": 0.01},
            {"set": "C0.mass", "from": 1, "to": 2, "step": 0.01},
        ],
    }
    found = prepared(read_fence(crowd))
    assert found.size <= MOST_BYTES
    assert found.runs >= (25 if carts == 2 else 9)
    assert sum(part["size"] for part in found.parts) == found.size


def test_a_scene_without_anything_to_change_needs_no_other_run() -> None:
    scene = fence(0)
    run = bake(scene.plain)
    assert isinstance(run, Run)
    assert prepare(scene, run) is None


def test_before_the_lock_a_page_holds_the_names_of_the_scripts_and_nothing_of_the_runs() -> None:
    text = """```scene
id: asks
carts: {A: {mass: 1 kg, position: 0.3 m, velocity: 0.4321 m/s}, B: {mass: 2.3 kg, position: 1 m}}
predict: {choice: [it stops, it turns back]}
until: 3 s
```"""
    (block,) = scan(text.splitlines(), front_matter=False)
    page = Page(Lesson("lesson.md"), prepares=True)
    html = made(block, page)
    assert len(page.prepared) == 1
    assert next(iter(page.prepared)) in html
    listed = re.search(r'data-prepared="([^"]*)"', html)
    assert listed is not None
    parts = json.loads(unescape(listed[1]))["parts"]
    told, _ = table(Prepared(parts, {}, page.prepared, runs=1, size=0))
    last = told["headers"][0]["final"]["v"]
    assert last["B"] > 0.1
    assert f"{last['B']:.3g}" not in html
