"""Two carts and a wall that count the digits of pi."""

from __future__ import annotations


def pi_billiard(digits, stiffness=None):
    """A light cart at rest between a wall and a cart 100^digits times as heavy that comes in."""
    contact = {"law": "instant"} if stiffness is None else {"stiffness": stiffness}
    return {
        "carts": {
            "light": {"mass": 1, "position": 1, "velocity": 0, "length": 0},
            "heavy": {"mass": 100**digits, "position": 2, "velocity": -1, "length": 0},
        },
        "track": {"left": "wall"},
        "contact": contact,
        "until": 1e6,
    }
