"""Sliders and switches for effects: what a lesson may ask for, and every way to get it wrong."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.bridge.protocol import answer
from sim.scene import SceneError, read_fence
from tests import registry

TILTED: dict[str, Any] = {
    "id": "tilted",
    **registry.two_carts(),
    "effects": [
        {"incline": {"angle": "2 deg"}},
        {"friction": {"coefficient": "0.02", "active": False}},
        {"push": {"cart": "A", "force": "1 N", "until": "1 s"}},
        {"push": {"cart": "B", "force": "-1 N"}},
    ],
}


def controls(*entries: dict[str, Any]) -> Any:
    return read_fence({**TILTED, "controls": list(entries)})


def slider(target: str, low: str, high: str, step: str) -> dict[str, Any]:
    return {"set": target, "from": low, "to": high, "step": step}


def test_a_slider_names_an_effect_by_its_kind_or_by_its_place() -> None:
    fence = controls(
        slider("incline.angle", "0 deg", "5 deg", "0.5 deg"),
        slider("effects.1.coefficient", "0", "0.1", "0.01"),
        slider("effects.2.push.force", "0 N", "2 N", "0.1 N"),
    )
    angle, coefficient, force = fence.controls
    assert (angle.unit, angle.shown(angle.high)) == ("deg", 5.0)
    assert angle.value == pytest.approx(math.radians(2))
    assert (coefficient.label, coefficient.value) == ("friction coefficient μ", 0.02)
    assert force.label == "force of the push on A by hand"


def test_a_switch_starts_as_the_scene_says() -> None:
    fence = controls({"switch": "friction"}, {"switch": "effects.3"})
    off, on = fence.switches
    assert (off.set, off.label, off.value) == ("friction.active", "friction", False)
    assert (on.set, on.label, on.value) == ("effects.3.active", "push on B by hand", True)


@pytest.mark.parametrize(
    ("entry", "where", "hint"),
    [
        ({"switch": "push"}, "controls.0.switch", "switch: effects.2 or switch: effects.3"),
        ({"switch": "drag"}, "controls.0.switch", "active: false"),
        ({"switch": "fricton"}, "controls.0.switch", "did you mean “friction”?"),
        ({"switch": "effects.9"}, "controls.0.switch", "effects of this scene"),
        ({"switch": "friction", "from": 0}, "controls.0.from", "{switch: friction}"),
        (slider("push.force", "0", "2", "1"), "controls.0.set", "effects.2.force"),
        (slider("friction.colour", "0", "2", "1"), "controls.0.set", "effects.1.coefficient"),
        (slider("friction.coefficient", "-1", "2", "1"), "controls.0.from", "for example"),
        (slider("incline.angle", "0 N", "5 N", "1 N"), "controls.0.from", "deg"),
    ],
)
def test_a_control_that_cannot_work_is_refused_with_its_place(
    entry: dict[str, Any], where: str, hint: str
) -> None:
    with pytest.raises(SceneError) as caught:
        controls(entry)
    (problem,) = caught.value.problems
    assert problem.where == where
    assert hint in problem.hint


def test_whether_an_effect_acts_is_true_or_false() -> None:
    with pytest.raises(SceneError) as caught:
        read_fence({**TILTED, "effects": [{"friction": {"coefficient": 0.1, "active": "no"}}]})
    assert caught.value.problems[0].where == "effects.0.friction.active"


def run(changes: dict[str, Any]) -> dict[str, Any]:
    plain = {key: value for key, value in TILTED.items() if key != "id"}
    return answer({"id": 0, "kind": "run", "scene": plain, "set": changes})[0]


def test_what_is_switched_off_does_nothing_and_stays_described() -> None:
    off = run({})
    assert "friction" in off["notSimulated"]
    assert "friction" not in off["work"]
    assert [e["active"] for e in off["effects"]] == [True, False, True, True]
    on = run({"friction.active": True, "effects.2.active": False, "incline.angle": "3 deg"})
    assert on["work"]["friction"] < 0
    assert [e["active"] for e in on["effects"]] == [True, True, False, True]
    assert on["effects"][0]["numbers"]["angle"] == pytest.approx(math.radians(3))


@pytest.mark.parametrize(
    "target", ["push.force", "effects.7.force", "friction.colour", "drag.active"]
)
def test_a_change_that_leads_nowhere_is_refused(target: str) -> None:
    header = run({target: 1})
    assert not header["ok"]
    assert header["problems"][0]["code"] == "unknown-path"
