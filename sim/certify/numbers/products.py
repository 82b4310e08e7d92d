"""The product of two intervals by their ends: two multiplications where one of them has a sign."""

from __future__ import annotations

from decimal import Decimal

from sim.certify.numbers.rounding import down, up

Ends = tuple[Decimal, Decimal]


def product(low: Decimal, high: Decimal, other_low: Decimal, other_high: Decimal) -> Ends:
    """[low, high] · [other_low, other_high], rounded outwards; all four are finite."""
    if low >= 0:
        return _times(low, high, other_low, other_high)
    if other_low >= 0:
        return _times(other_low, other_high, low, high)
    if high <= 0:
        return _turned(_times(high.copy_negate(), low.copy_negate(), other_low, other_high))
    if other_high <= 0:
        return _turned(_times(other_high.copy_negate(), other_low.copy_negate(), low, high))
    least = min(down().multiply(low, other_high), down().multiply(high, other_low))
    return least, max(up().multiply(low, other_low), up().multiply(high, other_high))


def _times(small: Decimal, great: Decimal, low: Decimal, high: Decimal) -> Ends:
    """The first is not negative."""
    least = down().multiply(small if low >= 0 else great, low)
    return least, up().multiply(great if high >= 0 else small, high)


def _turned(ends: Ends) -> Ends:
    return ends[1].copy_negate(), ends[0].copy_negate()
