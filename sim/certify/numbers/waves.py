"""Sines in decimals, between proved bounds; π with them.

    sin x = ± sin r or ± cos r        x = r + k π/2, |r| at most about π/4
    sin r = r − r³/3! + r⁵/5! − …     the terms fall, with signs in turn: what is left out is
                                      smaller than the first term that is left out

Each term is rounded four times, to GUARD digits more than are asked for, and is smaller than 1: so
much less than one unit of the last digit asked for comes from rounding. Over an interval a sine is
between its values at the ends, unless a crest (1) or a trough (−1) may lie inside.

π by J. Machin's formula of 1706: π/4 = 4 arctan(1/5) − arctan(1/239), in whole numbers.
"""

from __future__ import annotations

from dataclasses import dataclass
from decimal import ROUND_HALF_EVEN, Context, Decimal
from functools import cache

from sim.certify.numbers.rounding import context, down, up

GUARD = 10
"""Digits. A series of 2000 terms, each rounded four times, needs five."""


def pi() -> tuple[Decimal, Decimal]:
    """Bounds of π."""
    low, high = _pi(context.digits)
    return low, high


@cache
def _pi(digits: int) -> tuple[Decimal, Decimal]:
    """Each quotient of a series is rounded by less than 1, and so are its terms left out."""
    places = digits + GUARD
    one = 10**places
    found, wrong = 0, 0
    for factor, x in ((16, 5), (-4, 239)):
        term, k = one // x, 0
        while term:
            found += factor * (-1) ** k * (term // (2 * k + 1))
            wrong += 2 * abs(factor)
            term //= x * x
            k += 1
        wrong += 2 * abs(factor)
    low, high = (Decimal(found + sign * wrong).scaleb(-places, _wide(places)) for sign in (-1, 1))
    return low, high


@cache
def _wide(digits: int) -> Context:
    return Context(prec=digits + GUARD, rounding=ROUND_HALF_EVEN, traps=[])


@dataclass(frozen=True, slots=True)
class _Angle:
    """x = r + k π/2, with r known to `unsure`."""

    k: int
    r: Decimal
    unsure: Decimal
    work: Context


@dataclass(frozen=True, slots=True)
class _Point:
    """x + quarters π/2 = r + k π/2, and bounds of its sine."""

    k: int
    r: Decimal
    unsure: Decimal
    low: Decimal
    high: Decimal


def sines(low: Decimal, high: Decimal, *quarters: int) -> list[tuple[Decimal, Decimal]]:
    """Bounds of sin(x + quarters π/2) for x from `low` to `high`: sine is 0, cosine 1."""
    if not (low.is_finite() and high.is_finite()) or up().subtract(high, low) > 6:
        return [(Decimal(-1), Decimal(1))] * len(quarters)
    first = _reduced(low)
    last = first if low == high else _reduced(high)
    return [_between(first, last, quarter) for quarter in quarters]


def _between(first: _Angle, last: _Angle, quarters: int) -> tuple[Decimal, Decimal]:
    a = _at(first, quarters)
    b = a if last is first else _at(last, quarters)
    least, most = min(a.low, b.low), max(a.high, b.high)
    if last is not first:
        for k in range(a.k, b.k + 1):  # crests are at k = 1, 5, 9 …, troughs at 3, 7, 11 …
            after_a = k > a.k or a.r <= a.unsure
            before_b = k < b.k or b.r >= b.unsure.copy_negate()
            if k % 2 and after_a and before_b:
                least, most = (least, Decimal(1)) if k % 4 == 1 else (Decimal(-1), most)
    return max(least, Decimal(-1)), min(most, Decimal(1))


def _reduced(x: Decimal) -> _Angle:
    more = max(x.adjusted(), 0) if x else 0  # digits that go into k
    work = _wide(context.digits + more)
    below, above = _pi(context.digits + more)
    half = work.divide(below, Decimal(2))
    k = int(work.divide(x, half).to_integral_value())
    r = work.subtract(x, work.multiply(Decimal(k), half))
    rounding = Decimal(1).scaleb(2 - GUARD - context.digits)
    unsure = up().add(up().multiply(Decimal(abs(k)), up().subtract(above, below)), rounding)
    return _Angle(k, r, unsure, work)


def _at(angle: _Angle, quarters: int) -> _Point:
    k, r, unsure, work = angle.k + quarters, angle.r, angle.unsure, angle.work
    value = _series(Decimal(1), 0, r, work) if k % 2 else _series(r, 1, r, work)
    if k % 4 >= 2:
        value = value.copy_negate()
    wrong = up().add(unsure, Decimal(1).scaleb(-context.digits - GUARD // 2))
    return _Point(k, r, unsure, down().subtract(value, wrong), up().add(value, wrong))


def _series(first: Decimal, power: int, r: Decimal, work: Context) -> Decimal:
    """Term by term, until one is too small to be seen."""
    square = work.multiply(r, r)
    term = total = first
    smallest = Decimal(1).scaleb(-context.digits - GUARD)
    while term.copy_abs() > smallest:
        power += 2
        term = work.divide(work.multiply(term, square), Decimal(-power * (power - 1)))
        total = work.add(total, term)
    return total
