"""Two carts that bounce between two walls for ever."""

from __future__ import annotations


def box_of_two(until):
    """Elastic and instant: no energy is lost, however often they hit."""
    return {
        "carts": {
            "A": {"mass": 1, "position": "0.5", "velocity": "0.9"},
            "B": {"mass": "3.7", "position": "1.1", "velocity": "-0.4"},
        },
        "track": {"left": "wall", "right": "wall", "length": "1.6"},
        "contact": {"law": "instant"},
        "until": until,
    }
