"""A cart without bumpers against four things, one after the other."""

from __future__ import annotations

from typing import Any

AGAINST: dict[str, Any] = {
    "id": "against",
    "title": "Against foam, a spring, a board, a wall",
    "carts": {
        "A": {
            "mass": "0.5 kg",
            "position": "0.50 m",
            "velocity": "0.50 m/s",
            "length": "0.30 m",
            "bumper_length": "0 m",
        }
    },
    "track": {"length": "1.2 m", "right": "wall", "right_is": "foam"},
    "contact": {"restitution": 0.2, "stiffness": "40 N/m"},
    "until": "3 s",
    "show": ["v", "F", "p"],
    "with": ["lens", "free-body", "bars"],
    "presets": {
        "foam": {"contact.stiffness": "40 N/m", "track.right_is": "foam"},
        "soft spring": {"contact.stiffness": "60 N/m", "track.right_is": "spring"},
        "board": {"contact.stiffness": "300 N/m", "track.right_is": "board"},
        "wall": {"contact.stiffness": "1000 N/m", "track.right_is": "wall"},
    },
}
AT_PEAK = "el.time = el.trajectory.events.find((e) => e.kind === 'peak').t;"
THINGS = ("foam", "spring", "board")


def ends(**track: str) -> dict[str, Any]:
    """The same against other ends; `left` or `right` without a value: as it is."""
    return {**AGAINST, "track": {"length": "1.2 m", "right": "wall", **track}}
