"""Random lists of effects: a cart has one slope under it."""

from __future__ import annotations

from typing import Any


def one_slope(effects: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The effects without all inclines but the first: a second one under a cart is refused."""
    slopes = [entry for entry in effects if "incline" in entry]
    return [entry for entry in effects if not any(entry is one for one in slopes[1:])]
