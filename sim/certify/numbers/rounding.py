"""The precision of intervals, and the three ways in which `decimal` rounds.

A result is rounded from the exact one: downwards, upwards, or to the nearest. Operands are never
rounded, so a double goes in as it is. Nothing depends on the thread's own context.
"""

from __future__ import annotations

import decimal
from decimal import Decimal
from functools import cache

BITS_OF_A_DIGIT = 0.30103
"""log10 2."""


class Precision:
    """As python-flint's `ctx`: how many bits a number keeps."""

    prec = 53

    @property
    def digits(self) -> int:
        """Decimals that hold as much."""
        return _digits(self.prec)


def _digits(bits: int) -> int:
    return int(bits * BITS_OF_A_DIGIT) + 2


context = Precision()


def down() -> decimal.Context:
    """Rounds towards −∞."""
    return _context(context.prec, decimal.ROUND_FLOOR)


def up() -> decimal.Context:
    """Rounds towards +∞."""
    return _context(context.prec, decimal.ROUND_CEILING)


def near() -> decimal.Context:
    """Rounds to the nearest."""
    return _context(context.prec, decimal.ROUND_HALF_EVEN)


def next_down(x: Decimal) -> Decimal:
    """The next smaller number of this precision."""
    return near().next_minus(x)


def next_up(x: Decimal) -> Decimal:
    """The next greater one."""
    return near().next_plus(x)


@cache
def _context(bits: int, rounding: str) -> decimal.Context:
    low, high = decimal.MIN_EMIN, decimal.MAX_EMAX
    return decimal.Context(prec=_digits(bits), rounding=rounding, traps=[], Emin=low, Emax=high)
