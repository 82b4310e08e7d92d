"""friction: how large its force becomes, for the scale of a picture. Starting takes most."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def largest(effect: Mapping[str, Any], header: Mapping[str, Any]) -> float:
    """N, on the heaviest of its carts, moving or held."""
    n = effect["numbers"]
    masses = [body["mass"] for body in header["bodies"] if body["name"] in effect["carts"]]
    weight = header["gravity"] * max(masses, default=0.0)
    return float(weight * max(n["coefficient"], n.get("static", 0.0)))
