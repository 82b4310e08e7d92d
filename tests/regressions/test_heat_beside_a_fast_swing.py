"""A slow, damped contact in a row in which a light cart swings very fast: what it warms."""

from __future__ import annotations

from sim.dynamics.loop.run import run
from sim.scene import read_scene


def test_a_slow_damper_beside_a_fast_swing_keeps_its_account() -> None:
    """Swings of 3e-3 and 4e3 per second; the account was open by 3e-8 of all energy."""
    carts = {
        "A": {"mass": 1.0, "position": 9.5367431640625e-08},
        "B": {"mass": 2.2029876708984375e-8, "position": 4.863739013671875e-07},
        "C": {"mass": 0.0061893463134765625, "position": 7.724761962890625e-7, "velocity": 1.0},
    }
    plain = {
        "carts": {k: cart | {"length": 1.9073486328125e-07} for k, cart in carts.items()},
        "track": {"left": "wall", "right": "wall", "length": 1.3446807861328125e-6},
        "contact": {
            "law": "push-only",
            "restitution": 1,
            "stiffness": 0.21076202392578125,
            "pairs": {
                "left-A": {
                    "law": "push-only-uncorrected",
                    "restitution": 0.05,
                    "stiffness": 9.918212890625e-06,
                }
            },
        },
        "until": 4.72,
    }
    assert run(read_scene(plain)).ledger.imbalance() < 1e-11
