"""incline: how large its force becomes, for the scale of a picture."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any


def largest(effect: Mapping[str, Any], header: Mapping[str, Any]) -> float:
    """N, m g |sin θ| of the heaviest of its carts."""
    masses = [body["mass"] for body in header["bodies"] if body["name"] in effect["carts"]]
    weight = header["gravity"] * max(masses, default=0.0)
    return float(weight * abs(math.sin(effect["numbers"]["angle"])))
