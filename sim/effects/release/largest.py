"""release: how large its force becomes, for the scale of a picture. A spring begins with k L."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any


def largest(effect: Mapping[str, Any], header: Mapping[str, Any]) -> float:
    """N, sqrt(2 E k); at one instant there is no force to draw."""
    n = effect["numbers"]
    return math.sqrt(2.0 * n["energy"] * n.get("stiffness", 0.0))
