"""One stretch of a cart's motion, and what it may be."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Kind = Literal["rest", "hand", "coasting", "friction", "contact", "stop"]
KINDS: tuple[Kind, ...] = ("rest", "hand", "coasting", "friction", "contact", "stop")

STILL = 0.04
"""Share of the greatest speed below which a cart rests."""


@dataclass(frozen=True, slots=True)
class Segment:
    """From and until in s; `cart` 0 or 1; velocities in m/s where it begins and ends."""

    begin: float
    end: float
    cart: int
    kind: Kind
    speeds: tuple[float, float]
