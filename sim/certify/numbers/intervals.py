"""Intervals of decimals, for where Arb is not to be had: a page, a computer without python-flint.

[low, high] holds the truth. Sums, products and quotients of its ends are rounded downwards for
`low` and upwards for `high`; the standard library's `decimal` does that for every precision, and
its roots, exponentials and logarithms are right to half a unit of the last place, so the next
decimal outwards is a bound. Sines are in `waves`. A function that rises takes its bounds from the
two ends. The methods are those of python-flint's `arb` that a certificate calls: a comparison is
true only if it holds for every choice from both sides.

R. E. Moore, Interval Analysis (1966), chapters 2 and 4."""

from __future__ import annotations

import math
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from functools import lru_cache
from typing import Any

from sim.certify.numbers import products, waves
from sim.certify.numbers.rounding import context, down, near, next_down, next_up, up

ENDLESS = Decimal("Infinity")


class Interval:
    """All numbers from `low` to `high`; `radius` as with a ball around `middle`."""

    __slots__ = ("high", "low")

    def __init__(self, middle: Any = 0, radius: float = 0) -> None:
        if isinstance(middle, Fraction):
            top, bottom = Decimal(middle.numerator), Decimal(middle.denominator)
            self.low, self.high = down().divide(top, bottom), up().divide(top, bottom)
        else:
            self.low = self.high = Decimal(middle)
        if radius:
            wide = Decimal(radius)
            self.low, self.high = down().subtract(self.low, wide), up().add(self.high, wide)

    @staticmethod
    def of(low: Decimal, high: Decimal) -> Interval:
        """From its ends."""
        made = Interval.__new__(Interval)
        made.low, made.high = low, high
        return made

    @staticmethod
    def pi() -> Interval:
        """π."""
        return Interval.of(*waves.pi())

    # ------------------------------------------------------------------ what it is

    def is_finite(self) -> bool:
        """Has it bounds?"""
        return self.low.is_finite() and self.high.is_finite()

    def mid(self) -> Interval:
        """A number in it, exactly."""
        if self.low == self.high:
            return self
        middle = near().divide(near().add(self.low, self.high), Decimal(2))
        return Interval.of(middle, middle)

    def rad(self) -> Interval:
        """How far its ends are from `mid`, at most."""
        middle = self.mid().low
        most = max(up().subtract(self.high, middle), up().subtract(middle, self.low))
        return Interval.of(most, most)

    def lower(self) -> Interval:
        """Its lower end."""
        return Interval.of(self.low, self.low)

    def upper(self) -> Interval:
        """Its upper end."""
        return Interval.of(self.high, self.high)

    def union(self, other: Interval) -> Interval:
        """The smallest that holds both."""
        return Interval.of(min(self.low, other.low), max(self.high, other.high))

    def __float__(self) -> float:
        return float(self.mid().low)

    def __repr__(self) -> str:
        return f"[{self.low}, {self.high}]"

    # ------------------------------------------------------------------ comparisons that are proved

    def __lt__(self, other: Any) -> bool:
        return self.high < _of(other).low

    def __le__(self, other: Any) -> bool:
        return self.high <= _of(other).low

    def __gt__(self, other: Any) -> bool:
        return self.low > _of(other).high

    def __ge__(self, other: Any) -> bool:
        return self.low >= _of(other).high

    def __eq__(self, other: object) -> bool:
        same = _of(other)
        return self.low == self.high == same.low == same.high

    def __hash__(self) -> int:
        return hash((self.low, self.high))

    # ------------------------------------------------------------------ arithmetic

    def __neg__(self) -> Interval:
        return Interval.of(self.high.copy_negate(), self.low.copy_negate())

    def __abs__(self) -> Interval:
        if self.low >= 0:
            return self
        if self.high <= 0:
            return -self
        return Interval.of(Decimal(0), max(self.low.copy_negate(), self.high))

    def __add__(self, other: Any) -> Interval:
        more = _of(other)
        return Interval.of(down().add(self.low, more.low), up().add(self.high, more.high))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Interval:
        less = _of(other)
        low = down().subtract(self.low, less.high)
        return Interval.of(low, up().subtract(self.high, less.low))

    def __rsub__(self, other: Any) -> Interval:
        return _of(other) - self

    def __mul__(self, other: Any) -> Interval:
        by = _of(other)
        if not (self.is_finite() and by.is_finite()):
            return Interval.of(ENDLESS.copy_negate(), ENDLESS)
        return Interval.of(*products.product(self.low, self.high, by.low, by.high))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Interval:
        by = _of(other)
        if not (by.low > 0 or by.high < 0) or not (self.is_finite() and by.is_finite()):
            return Interval.of(ENDLESS.copy_negate(), ENDLESS)
        pairs = [(a, b) for a in (self.low, self.high) for b in (by.low, by.high)]
        low = min(down().divide(a, b) for a, b in pairs)
        return Interval.of(low, max(up().divide(a, b) for a, b in pairs))

    def __rtruediv__(self, other: Any) -> Interval:
        return _of(other) / self

    def __pow__(self, power: int) -> Interval:
        if power < 0:
            return 1 / self**-power
        made = Interval(1)
        for _ in range(power):
            made = made * self
        return made

    # ------------------------------------------------------------------ functions

    def sqrt(self) -> Interval:
        """The root; of what may be negative it has no bound."""
        if self.low < 0:
            return Interval.of(ENDLESS.copy_negate(), ENDLESS)
        return Interval.of(_root(self.low, next_down), _root(self.high, next_up))

    def exp(self) -> Interval:
        """e to this power."""
        if self == 0:
            return Interval(1)
        return Interval.of(next_down(near().exp(self.low)), next_up(near().exp(self.high)))

    def log(self) -> Interval:
        """The natural logarithm; of what may be nought or less it has no bound."""
        if self.low <= 0:
            return Interval.of(ENDLESS.copy_negate(), ENDLESS)
        if self == 1:
            return Interval(0)
        return Interval.of(next_down(near().ln(self.low)), next_up(near().ln(self.high)))

    def sin(self) -> Interval:
        """The sine of an angle in rad."""
        return Interval.of(*waves.sines(self.low, self.high, 0)[0])

    def cos(self) -> Interval:
        """The cosine: a quarter of a turn ahead."""
        return Interval.of(*waves.sines(self.low, self.high, 1)[0])

    def sin_cos(self) -> tuple[Interval, Interval]:
        """Both, from one reduction of the angle."""
        sine, cosine = waves.sines(self.low, self.high, 0, 1)
        return Interval.of(*sine), Interval.of(*cosine)

    def sinh(self) -> Interval:
        """It rises."""
        low, high = (_halves(end, -1) for end in (self.lower(), self.upper()))
        return Interval.of(low.low, high.high)

    def cosh(self) -> Interval:
        """It falls to 1 at 0, and rises from there."""
        size = abs(self)
        low, high = (_halves(end, 1) for end in (size.lower(), size.upper()))
        return Interval.of(max(low.low, Decimal(1)), high.high)

    def sinh_cosh(self) -> tuple[Interval, Interval]:
        """Both."""
        return self.sinh(), self.cosh()

    def acosh(self) -> Interval:
        """The positive number with this cosh; it rises."""
        low, high = ((c + (c * c - 1).sqrt()).log() for c in (self.lower(), self.upper()))
        return Interval.of(low.low, high.high)

    def acos(self) -> Interval:
        """The angle between 0 and π with this cosine: Newton's steps, then ends that are proved."""
        x = Interval(math.acos(float(self)))
        for _ in range(context.prec.bit_length()):
            x = (x + (x.cos() - self) / x.sin()).mid()
        wide = x * (Interval(2) ** (-7 * context.prec // 8)) + 4 * self.rad() / x.sin()
        low, high = (x - wide).mid(), (x + wide).mid()
        if low.cos() > self and high.cos() < self:
            return low.union(high)
        return Interval.of(ENDLESS.copy_negate(), ENDLESS)


def _of(other: Any) -> Interval:
    if isinstance(other, Interval):
        return other
    return _whole(other) if type(other) is int else Interval(other)


@lru_cache(maxsize=256)
def _whole(number: int) -> Interval:
    return Interval(number)


def _root(x: Decimal, outwards: Callable[[Decimal], Decimal]) -> Decimal:
    root = near().sqrt(x)
    return root if Fraction(root) ** 2 == Fraction(x) else outwards(root)


def _halves(x: Interval, sign: int) -> Interval:
    """(eˣ ± e⁻ˣ)/2 of one number."""
    return (x.exp() + sign * (-x).exp()) / 2
