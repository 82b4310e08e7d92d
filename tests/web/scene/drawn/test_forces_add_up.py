"""The forces that are drawn and told on a cart are those that its motion needs, at any instant."""

from __future__ import annotations

from typing import Any

import pytest

from tests import registry
from tests.web.scene.given.widget_site import in_node
from tests.web.scene.given.wired import READ, wired

SUMS = """give(data.map((one) => {
  const run = opened(one);
  const { header, trajectory } = run;
  const until = trajectory.t[trajectory.t.length - 1];
  return header.bodies.map(({ name, mass }) => {
    const [curve] = s.seriesOf("R", header, trajectory, 0).filter(({ label }) => label === name);
    const scale = Math.max(...Array.from(trajectory.a[name], Math.abs)) * mass;
    let most = 0;
    for (let k = 0; k < trajectory.t.length - 1; k += 1) {
      if (trajectory.t[k] === trajectory.t[k + 1]) continue;
      const when = [trajectory.t[k], (trajectory.t[k] + trajectory.t[k + 1]) / 2];
      for (const [n, at] of when.entries()) {
        const drawn = n ? t.valueAt(trajectory.t, curve.values, curve.slopes, at)
          : mass * trajectory.a[name][k];
        most = Math.max(most, Math.abs(f.resultant(run, name, at, 1e-12 * scale) - drawn));
      }
    }
    return [most, scale];
  });
}));"""
BETWEEN = 1e-2
"""Of the greatest: between rows forces of effects are straight lines, those of contacts cubics."""


def pushed(law: str) -> dict[str, Any]:
    """A and B stick together and are pushed; B runs into a bumper at the right wall."""
    return {
        "carts": {
            "A": {"mass": 1, "position": "0.3", "velocity": "0.6"},
            "B": {"mass": 2, "position": "0.7"},
        },
        "track": {"length": "1.6", "right": "wall"},
        "contact": {"law": "bumper", "stiffness": 200, "pairs": {"A-B": {"law": law}}},
        "effects": [{"push": {"cart": "A", "force": "0.5"}}],
        "until": 5,
    }


def test_the_forces_told_on_a_cart_add_up_to_what_its_motion_needs() -> None:
    names = [name for name in registry.NAMES if registry.scene(name).until < 100]
    runs = [wired(registry.plain(name)) for name in names]
    for name, carts in zip(names, in_node(READ + SUMS, runs), strict=True):
        for most, scale in carts:
            assert most <= BETWEEN * scale, name


def test_what_holds_two_together_that_stick_is_among_their_forces() -> None:
    """Else B, which A holds on to, had the push of the wall alone, and a false acceleration."""
    for most, scale in in_node(READ + SUMS, [wired(pushed("velcro"))])[0]:
        assert scale > 1
        assert most <= BETWEEN * scale


@pytest.mark.parametrize(("law", "told"), [("velcro", False), ("bumper", True)])
def test_the_area_of_a_touch_is_no_change_of_momentum_of_a_cart_that_another_holds(
    law: str, told: bool
) -> None:
    """B hits the wall: all that it gets comes from there, or A, which sticks to it, has a part."""
    plain = {**pushed(law), "effects": [], "until": 6}
    changes = in_node(
        READ
        + """const run = opened(data);
        const windows = w.touches(run.header.events, run.header.until);
        const touch = windows.find(({ pair }) => pair === "B-right");
        give(i.changes(run, windows, touch, touch.end));""",
        wired(plain),
    )
    found = {one["name"]: one["change"] for one in changes}
    assert (found["B"] is not None) == told
