"""Limits that lack the unit of their neighbours, and effects beside carts that cannot be used."""

from __future__ import annotations

import pytest

from sim.scene import read_fence
from tests import registry
from tests.scene.refused import problems

FENCE = {**registry.two_carts(), "id": "crash"}


PUSH = {"push": {"cart": "A", "force": "1 N", "from": 0, "to": "1 s"}}


@pytest.mark.parametrize("carts", [{"小车": {"mass": 1, "position": 0}}, {}, None, ["A"]])
@pytest.mark.parametrize(
    "effect",
    [PUSH, {"friction": {"coefficient": 0.02}}, {"spring": {"between": ["A", "B"]}}],
)
def test_an_effect_beside_carts_that_cannot_be_used_hides_not_what_is_wrong_with_them(
    carts, effect
):
    found = problems({"carts": carts, "effects": [effect, {"frictoin": {}}]})
    assert {where for where, _ in found if where.startswith("carts")}
    assert ("effects.1.frictoin", "unknown-effect") in found
    assert "unknown-body" not in {code for _, code in found}


@pytest.mark.parametrize(
    ("limits", "bare"),
    [
        (("10 cm", 90, "5 cm"), "to"),
        ((".1", "90 cm", "5 cm"), "from"),
        (("0", "90 cm", "1e0"), "step"),
    ],
)
def test_a_limit_without_a_unit_beside_one_in_cm_is_refused(limits, bare):
    entry = {"set": "A.position", **dict(zip(("from", "to", "step"), limits, strict=True))}
    found = problems({**FENCE, "controls": [entry]}, read_fence)
    assert found == {(f"controls.0.{bare}", "wrong-unit")}


@pytest.mark.parametrize("limits", [("0 %", 1, "10 %"), ("10 %", "0.9", 0.1)])
def test_a_ratio_beside_one_in_percent_needs_no_unit(limits):
    entry = {"set": "contact.restitution", **dict(zip(("from", "to", "step"), limits, strict=True))}
    scene = {**FENCE, "contact": {"restitution": 0.5}, "controls": [entry]}
    (control,) = read_fence(scene).controls
    assert (control.low, control.high, control.step) == pytest.approx(
        [{"0 %": 0, "10 %": 0.1}[limits[0]], float(limits[1]), 0.1]
    )


@pytest.mark.parametrize("limits", [(0, "0.5 m", "0.1"), ("0", "50 cm", "1 mm"), (0, 1, 0.1)])
def test_limits_in_si_and_nought_need_no_unit(limits):
    entry = {"set": "A.position", **dict(zip(("from", "to", "step"), limits, strict=True))}
    assert read_fence({**FENCE, "controls": [entry]}).controls
