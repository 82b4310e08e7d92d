"""Decimals and units of the numbers that a scene shows: chosen once, from the greatest of them."""

from __future__ import annotations

from collections.abc import Sequence

MAX_DECIMALS = 12
SLOW = 0.01  # m/s; scenes with no greater speed speak of mm/s


def exponent(value: float) -> int:
    """The power of ten of the first digit of `value`; 0 for 0."""
    return int(f"{abs(value):.16e}".split("e")[1]) if value else 0


def decimals_for(scale: float, figures: int = 3) -> int:
    """Decimals that show a value as large as `scale` with so many figures."""
    return min(MAX_DECIMALS, max(0, figures - 1 - exponent(scale)))


def decimals_for_all(scales: Sequence[float]) -> int:
    """Three figures of the largest value, and one of the smallest; six of the largest at most."""
    least = decimals_for(min(scales), 1)
    return max(decimals_for(max(scales)), min(least, decimals_for(max(scales), 6)))


def speed_unit(scale: float) -> tuple[float, str]:
    """The unit of all velocities of a scene with that greatest speed: m/s in it, and its name."""
    return (0.001, "mm/s") if scale <= SLOW else (1.0, "m/s")
