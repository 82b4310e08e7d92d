"""Balls: exact inputs, signs that are proved, bounds that are rounded outwards.

A comparison of balls is true only where it holds for every choice from them; `x > 0` false says
nothing. A double is a ball of radius 0.
"""

from __future__ import annotations

import math
from fractions import Fraction

from sim.certify.numbers.arithmetic import Ball, arb, ends, fraction
from sim.scene.said import said

__all__ = ["Ball"]

ZERO = arb(0)


class NotProvableError(Exception):
    """With these inputs it cannot be decided what happens; the message says what (`said`)."""


class NoBoundError(NotProvableError):
    """There is no bound for this kind of motion here: more digits would not help."""


def exact(number: float) -> Ball:
    """The ball that holds this double and nothing else."""
    return arb(number)


def between(low: Fraction, high: Fraction) -> Ball:
    """The smallest ball around an interval."""
    return fraction(low) if low == high else fraction(low).union(fraction(high))


UNIT = between(Fraction(-1), Fraction(1))
"""0 ± 1."""


def is_zero(x: Ball) -> bool:
    """Is it nought and nothing else?"""
    return bool(x == 0)


def sign(x: Ball, what: str) -> int:
    """−1, 0 or 1; raises where the ball holds more than one of them."""
    if x > 0:
        return 1
    if x < 0:
        return -1
    if is_zero(x):
        return 0
    raise NotProvableError(what)


def lower(x: Ball) -> Fraction:
    """An exact bound from below."""
    return _ends(x)[0]


def upper(x: Ball) -> Fraction:
    """An exact bound from above."""
    return _ends(x)[1]


def _ends(x: Ball) -> tuple[Fraction, Fraction]:
    if not x.is_finite():
        raise NotProvableError(said("a number has no bound"))
    return ends(x)


def bounds(x: Ball) -> tuple[float, float]:
    """The doubles next to the ball, outwards: the nearest that enclose it."""
    low, high = _ends(x)
    below, above = _double(low), _double(high)
    if Fraction(below) > low:
        below = math.nextafter(below, -math.inf)
    if Fraction(above) < high:
        above = math.nextafter(above, math.inf)
    return below, above


def _double(number: Fraction) -> float:
    try:
        return float(number)
    except OverflowError:
        raise NotProvableError(said("a number is larger than any double")) from None
