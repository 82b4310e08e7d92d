"""drag: how large its force becomes, for the scale of a picture."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def largest(effect: Mapping[str, Any], header: Mapping[str, Any]) -> float:
    """N, at the greatest speed of the start."""
    n = effect["numbers"]
    speed = max(abs(body["velocity"]) for body in header["bodies"])
    return float(n.get("linear", 0.0) * speed + n.get("quadratic", 0.0) * speed**2)
