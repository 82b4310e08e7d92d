"""The method, and its steps, that a page asks for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sim.dynamics.stepping.methods import ADAPTIVE, NAMES, MethodChoice
from sim.scene import Problem, Scene, SceneError
from sim.scene.said import said


def method_choice_of(scene: Scene, request: Mapping[str, Any], most: int) -> MethodChoice:
    """The method that a page asks for, in `most` steps; raises SceneError."""
    method, parts = request.get("method"), request.get("parts", 0)
    if method not in NAMES:
        problem = Problem(("method",), "unknown-method", said("no such method"), ", ".join(NAMES))
        raise SceneError([problem])
    if method in ADAPTIVE:
        return MethodChoice(
            str(method), rtol=min(0.1, max(1e-13, float(request.get("rtol") or 1e-9)))
        )
    if not isinstance(parts, int) or not 1 <= parts <= most:
        message = said("no such number of steps")
        hint = said("{low} to {high}", low="1", high=str(most))
        raise SceneError([Problem(("parts",), "range", message, hint)])
    return MethodChoice(str(method), step=scene.until / parts)
