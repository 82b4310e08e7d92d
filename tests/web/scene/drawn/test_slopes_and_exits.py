"""Curves between two rows, what else moved a cart meanwhile, and where it leaves the picture."""

from __future__ import annotations

from typing import Any

import pytest

from tests import registry
from tests.web.scene.given.seen_run import seen

SLOPES = """const { seriesOf } = await import(view + "/series.js");
const rows = run.trajectory.t;
give(["x", "v", "a", "p", "energy", "R", "F", "signed"].flatMap((quantity) => {
  const [what, signed] = quantity === "signed" ? ["F", true] : [quantity, false];
  return seriesOf(what, run.header, run.trajectory, data.camera, signed).map((curve) => {
    let [off, most, told] = [0, 0, 0];
    for (let k = 1; curve.slopes && k < rows.length; k += 1) {
      const [dt, rise] = [rows[k] - rows[k - 1], curve.values[k] - curve.values[k - 1]];
      if (!(dt > 0)) continue; // a jump
      const meant = (dt * (curve.slopes[k] + curve.slopes[k - 1])) / 2;
      off += Math.abs(rise - meant);
      most += Math.abs(rise);
      told += 1;
    }
    return [`${quantity} ${curve.label}`, told, off, most];
  });
}));"""
WALLED: dict[str, Any] = {
    "carts": {
        "A": {"mass": 0.5, "position": 0.4, "velocity": 0.6},
        "B": {"mass": 1, "position": 1.3},
    },
    "track": {"length": 2.4, "right": "wall"},
    "contact": {"restitution": 0.8, "stiffness": 400},
    "until": 6,
}
PULLING: dict[str, Any] = {**WALLED, "contact": {"law": "paper", **WALLED["contact"]}}


@pytest.mark.parametrize("camera", [0.0, 0.3])
@pytest.mark.parametrize(
    "plain", [WALLED, PULLING, registry.plain("spring-pair")], ids=["bumper", "paper", "spring"]
)
def test_a_curve_rises_between_its_rows_as_its_slopes_say(
    plain: dict[str, Any], camera: float
) -> None:
    told = seen(plain, SLOPES, camera=camera)
    assert any(name.startswith("F ") and rows for name, rows, *_ in told)
    for name, _, off, most in told:
        assert off <= 0.05 * most + 1e-9, name


OUT: dict[str, Any] = {
    "carts": {
        "A": {"mass": 1, "length": 0.2, "position": 0.5, "velocity": -0.4},
        "B": {"mass": 1, "length": 0.2, "position": 1.5, "velocity": 0.5},
    },
    "track": {"length": 2},
    "until": 6,
}


@pytest.mark.parametrize("camera", [0.0, 0.1, -0.1])
def test_a_cart_leaves_at_its_own_side_with_the_velocity_that_the_camera_sees(
    camera: float,
) -> None:
    left, right = -0.4 - camera, 0.5 - camera
    script = """const { exits } = await import(view + "/exits.js");
    const found = exits(run, { low: 0, high: 2 }, data.camera);
    give(found.map((e) => [e.name, e.side, e.t, e.velocity]));"""
    found = seen(OUT, script, camera=camera)
    assert [row[:2] for row in found] == [["A", "left"], ["B", "right"]]
    assert [row[2] for row in found] == pytest.approx([-0.6 / left, 0.6 / right])
    assert [row[3] for row in found] == pytest.approx([left, right])


CHANGES = """const { changes } = await import(view + "/impulse.js");
const { windowsOf } = await import(view + "/windows.js");
const all = windowsOf(run);
give(all.map((one) => changes(run, all, one, one.end).map(({ change }) => change)));"""


@pytest.mark.parametrize(
    ("more", "known"),
    [
        ({}, [True, True]),
        ({"effects": [{"friction": {"coefficient": 0.01}}]}, [False, False]),
        ({"effects": [{"friction": {"coefficient": 0.01, "active": False}}]}, [True, True]),
        ({"effects": [{"friction": {"coefficient": 0.01, "carts": ["A"]}}]}, [False, True]),
    ],
)
def test_the_impulse_of_a_touch_is_compared_with_what_nothing_else_has_changed(
    more: dict[str, Any], known: list[bool]
) -> None:
    """B hits the wall later: that takes nothing from the first touch."""
    first, *later = seen({**WALLED, **more}, CHANGES)
    assert [change is not None for change in first] == known
    if all(known):
        assert later
        assert first[0] == pytest.approx(-first[1], rel=1e-9)
        assert first[0] == pytest.approx(-1.8 * 0.6 * 0.5 / 1.5, rel=1e-6)  # −(1 + e) u μ
