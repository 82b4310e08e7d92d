"""The force that a reader finds from m Δv/Δt is the contact's: its impulse over its time."""

from __future__ import annotations

from typing import Any

import pytest

from tests.web.scene.given.widget_site import in_node
from tests.web.scene.given.wired import READ, wired

BUMP: dict[str, Any] = {
    "carts": {
        "A": {"mass": 0.5, "position": 0.4, "velocity": 0.6},
        "B": {"mass": 2.0, "position": 1.2},
    },
    "track": {"length": 2.4},
    "contact": {"restitution": 0.8, "stiffness": 100},
    "until": 3,
}
FOUND = """const m = await import(`${source}/predict/mean-forces.js`);
const { whyNone } = await import(`${source}/predict/find-forces.js`);
const run = opened(data);
give([m.meanForces(run), whyNone(run)]);"""


def found(**changes: Any) -> tuple[dict[tuple[str, str], float], str]:
    """The mean forces by cart and other, and what is said where there are none."""
    means, why = in_node(READ + FOUND, wired({**BUMP, **changes}))
    return {(one["cart"], one["other"]): one["value"] for one in means}, why


@pytest.mark.parametrize("law", ["bumper", "paper", "push-only", "hertz"])
def test_the_mean_forces_on_two_that_touch_are_equal_and_opposite(law: str) -> None:
    means, _ = found(contact={"law": law, "restitution": 0.8, "stiffness": 100})
    assert means["B", "A"] > 0
    assert means["A", "B"] == -means["B", "A"]


def test_the_mean_force_of_a_contact_is_its_impulse_over_its_time() -> None:
    means, _ = found()
    impulse, time = 0.5 * (0.6 + 0.264), 0.17882258878
    assert means["B", "A"] == pytest.approx(impulse / time, rel=1e-9)


@pytest.mark.parametrize(
    "effect",
    [
        {"friction": {"coefficient": 0.03}},
        {"push": {"cart": "A", "force": "1 N"}},
        {"incline": {"angle": "2 deg"}},
    ],
)
def test_nobody_is_asked_for_a_force_that_is_not_what_the_motion_tells(
    effect: dict[str, Any],
) -> None:
    """With friction −1.03 N on A and 0.458 N on B were taken for the two forces of one contact."""
    means, why = found(effects=[effect])
    assert means == {}
    assert "another force acts" in why


def test_a_push_that_has_ended_before_the_touch_hides_no_force() -> None:
    push = {"push": {"cart": "A", "force": "0.2 N", "until": "0.5 s"}}
    means, _ = found(effects=[push])
    assert means["A", "B"] == -means["B", "A"] != 0


def test_of_three_in_a_row_that_push_at_once_none_is_asked_for() -> None:
    carts = {**BUMP["carts"], "C": {"mass": 1.0, "position": 1.4}}
    carts = {
        **carts,
        "B": {**carts["B"], "length": "0.2 m"},
        "C": {**carts["C"], "length": "0.2 m"},
    }
    means, _ = found(carts=carts)
    assert ("A", "B") not in means


def test_where_none_touch_that_is_what_is_said() -> None:
    means, why = found(until=0.5)
    assert means == {}
    assert "no two touch" in why


def test_a_contact_that_the_run_ends_in_has_no_mean_force() -> None:
    """Its greatest force passes before: that is no parting, and the velocities are not the last."""
    means, why = found(contact={"restitution": 1, "stiffness": 5}, until=1.75)
    assert means == {}
    assert why
