"""What begins to slide as a run begins: told where something happens to it, not where it was so."""

from __future__ import annotations

from typing import Any

import pytest

from sim.certify.certificate import certify, document
from sim.dynamics.loop.run import run
from sim.scene import read_scene


def events(plain: dict[str, Any]) -> list[tuple[str, tuple[str, ...]]]:
    return [(event.kind, event.bodies) for event in run(read_scene(plain)).record.events]


@pytest.mark.parametrize("pushed", [[], [{"push": {"cart": "B", "force": 5}}]])
@pytest.mark.parametrize("law", ["instant", "paper", "push-only", "bumper"])
def test_a_touch_as_the_run_begins_starts_a_resting_cart_as_one_a_moment_later(
    law: str, pushed: list[dict[str, Any]]
) -> None:
    """It got no start, but its stop later. A push from the first instant moves it anyway."""
    stiff = {"stiffness": 500}
    plain = {
        "carts": {
            "A": {"mass": 1, "position": 0.2, "velocity": 1},
            "B": {"mass": 1, "position": 0.4},
        },
        "contact": {"law": law, "restitution": 0.5} | ({} if law == "instant" else stiff),
        "effects": [{"friction": {"coefficient": 0.2, "carts": ["B"]}}, *pushed],
        "until": 0.5,
    }
    at_once = events(plain)
    carts: Any = plain["carts"]
    carts["A"]["position"] = 0.199
    assert events(plain) == at_once
    assert (("start", ("B",)) in at_once) == (not pushed)
    carts["A"]["position"] = 0.2
    told = document(certify(read_scene(plain)))
    if told["final"]["x"]:
        assert [(one["kind"], tuple(one["bodies"])) for one in told["events"]] == at_once
