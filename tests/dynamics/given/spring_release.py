"""A pair of carts that a spring parts, and its run."""

from __future__ import annotations

from typing import Any

from sim.dynamics.loop.run import run
from sim.dynamics.result.finished import Run
from sim.scene import read_scene


def pair(**changes: Any) -> dict[str, Any]:
    """0.06 J in 20 N/m between 0.5 kg and 1 kg, let go at 0.25 s."""
    release = {"between": ["A", "B"], "energy": 0.06, "at": 0.25, "stiffness": 20}
    plain: dict[str, Any] = {
        "carts": {"A": {"mass": 0.5, "position": 1.1}, "B": {"mass": 1, "position": 1.3}},
        "effects": [{"release": release | changes.pop("release", {})}],
        "until": 1,
    }
    return plain | changes


def done(plain: dict[str, Any]) -> Run:
    return run(read_scene(plain))
