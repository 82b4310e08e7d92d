"""magnets: how large their force becomes, for the scale of a picture.

Nearest, all energy of the approach is between them: C / ((n − 1) r^(n−1)) = ½ mu w² + what is there
at the start, w the greatest closing speed of the scene; for n = 1 r falls by exp(½ mu w²/C).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from sim.effects.where import room_between

LEAST_ROOM = 0.01
"""m. Nearer at the start than that, the start does not say how near they come."""

SMALLEST = 1e-3
"""m. With n = 1 a fast cart comes unbelievably near; no scale is made for that."""


def largest(effect: Mapping[str, Any], header: Mapping[str, Any]) -> float:
    """N, of the two alone and elastic: never less than at the start."""
    n, c = effect["numbers"].get("power", 3.0), effect["numbers"]["strength"]
    bodies = {body["name"]: body for body in header["bodies"]}
    left, right = effect["between"]
    room = max(room_between(effect["between"], header), LEAST_ROOM)
    mu = 1.0 / sum(1.0 / bodies[name]["mass"] for name in (left, right) if name in bodies)
    speeds = [body["velocity"] for body in bodies.values()]
    walled = left not in bodies or right not in bodies
    closing = max(map(abs, speeds)) if walled else max(speeds) - min(speeds)
    moving = 0.5 * mu * closing**2
    if n == 1.0:
        nearest = room * math.exp(-moving / c)
    else:
        energy = moving + c / (n - 1.0) * room ** (1.0 - n)
        nearest = (c / ((n - 1.0) * energy)) ** (1.0 / (n - 1.0))
    return float(c / max(nearest, SMALLEST) ** n)
