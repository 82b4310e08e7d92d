"""A cart that hops on a bumper of small e: thousands of contacts, and the wall's account closes.

On the steep line k/e² an overlap differs from its place of rest in its last figures only, so that
k/e² times its integral kept four of an impulse. What changes the motion keeps them all.
"""

from __future__ import annotations

import pytest

from sim.dynamics.loop.run import run
from sim.scene import read_scene


@pytest.mark.parametrize("e", [1e-6, 1e-4, 1e-3])
def test_impulses_of_walls_and_slope_are_what_the_cart_has_more_in_the_end(e: float) -> None:
    scene = read_scene(
        {
            "carts": {"A": {"mass": 1.0, "position": 0.4, "velocity": -1.07}},
            "track": {"left": "wall"},
            "contact": {"law": "bumper", "restitution": e, "stiffness": 71.19},
            "effects": [{"incline": {"angle": "-0.01 deg"}}],
            "until": 2,
        }
    )
    done = run(scene)
    assert len([event for event in done.record.events if event.kind == "contact"]) > 1
    assert done.ledger.external == pytest.approx(done.v[0] + 1.07, abs=1e-13)
