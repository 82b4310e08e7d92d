"""spring: how large its force becomes, for the scale of a picture: at least that of the start."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sim.effects.where import room_between


def largest(effect: Mapping[str, Any], header: Mapping[str, Any]) -> float:
    """N, k |L − r| with r the room between its ends at the start."""
    n = effect["numbers"]
    return float(n["stiffness"] * abs(n["length"] - room_between(effect["between"], header)))
