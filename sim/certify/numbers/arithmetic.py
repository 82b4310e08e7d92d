"""The numbers of a certificate: balls of Arb where python-flint is installed, else intervals.

Both have the methods that a certificate calls, and both round outwards. Arb is some ten times as
fast; intervals need nothing but the standard library, so a page can prove digits too.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

Ball = Any
"""An `arb` (python-flint carries no types), or an `Interval`."""

arb: Any
ctx: Any
try:
    import flint

    arb, ctx, ARB = flint.arb, flint.ctx, True
except ImportError:
    from sim.certify.numbers import intervals, rounding

    arb, ctx, ARB = intervals.Interval, rounding.context, False

__all__ = ["ARB", "Ball", "arb", "ctx", "ends", "fraction"]


def fraction(number: Fraction) -> Ball:
    """The smallest ball around a fraction."""
    return arb(flint.fmpq(number.numerator, number.denominator)) if ARB else arb(number)


def ends(x: Ball) -> tuple[Fraction, Fraction]:
    """Its bounds, exactly; `x` is finite."""
    if not ARB:
        return Fraction(x.low), Fraction(x.high)
    if x.is_exact():
        return (middle := _dyadic(x)), middle
    return _dyadic(x.lower()), _dyadic(x.upper())


def _dyadic(x: Ball) -> Fraction:
    mantissa, exponent = (int(part) for part in x.man_exp())
    return Fraction(mantissa << exponent) if exponent >= 0 else Fraction(mantissa, 1 << -exponent)
