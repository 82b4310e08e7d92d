"""Mean, standard deviation and the interval of a mean: of one list of numbers.

Sums are exact (`fractions`) and rounded once, so that no order of the files changes a digit.
Standard deviations are those of a sample, with n − 1.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from sim.classroom.refusal import RefusalError, at_least, numbers
from sim.classroom.statistics.tails import t_quantile
from sim.scene.said import said

Exact = int | Fraction
"""A number of marks without rounding: sums of such numbers do not depend on their order."""


@dataclass(frozen=True, slots=True)
class Spread:
    """A list of numbers in short: how many, their mean and their sample standard deviation."""

    n: int
    mean: float
    sd: float

    @property
    def se(self) -> float:
        """Standard error of the mean."""
        return self.sd / math.sqrt(self.n)

    def interval(self, level: float = 0.95) -> tuple[float, float]:
        """Where the mean of many such students would lie: mean ± t · se. Needs scipy."""
        at_least(self.n, 2)
        half = t_quantile(0.5 + level / 2, self.n - 1) * self.se
        return self.mean - half, self.mean + half


def spread(values: Sequence[float]) -> Spread:
    """Mean and standard deviation; of one number there is no deviation, and it is 0."""
    given = numbers(values)
    at_least(len(given), 1)
    exact = list(map(Fraction, given))
    squares = sum((value * value for value in exact), Fraction(0))
    return spread_of(len(exact), sum(exact, Fraction(0)), squares)


def spread_of(n: int, total: Exact, squares: Exact) -> Spread:
    """The same from how many numbers there are, their sum and the sum of their squares."""
    at_least(n, 1)
    sd = root(around(n, total, squares) / (n - 1)) if n > 1 else 0.0
    return Spread(n, float(Fraction(total) / n), sd)


def around(n: int, total: Exact, squares: Exact) -> Fraction:
    """Sum of the squared deviations from the mean, from the sum and the sum of squares."""
    return squares - Fraction(total) * total / n


def median(values: Sequence[float]) -> float:
    """The middle one, or the middle between the two middle ones."""
    order = sorted(numbers(values))
    at_least(len(order), 1)
    half = len(order) // 2
    return order[half] if len(order) % 2 else (order[half - 1] + order[half]) / 2


def moments(first: Sequence[float], second: Sequence[float]) -> tuple[Fraction, Fraction]:
    """Sum of the first, and sum of the products of both deviations from their means; exact."""
    if len(first) != len(second):
        raise RefusalError(_no_pairs(first, second))
    a, b = [Fraction(x) for x in first], [Fraction(x) for x in second]
    total = sum(a, Fraction(0))
    products = sum((x * y for x, y in zip(a, b, strict=True)), Fraction(0))
    return total, products - total * sum(b, Fraction(0)) / len(a)


def root(square: Fraction) -> float:
    """The square root of an exact number that is not negative, rounded once."""
    if square <= 0:
        return 0.0
    shift = max(0, 128 - (square.numerator.bit_length() - square.denominator.bit_length()))
    shift += shift % 2
    whole = math.isqrt((square.numerator << shift) // square.denominator)
    return float(Fraction(whole, 1 << shift // 2))


def _no_pairs(first: Sequence[float], second: Sequence[float]) -> str:
    return said("{one} and {other} numbers do not make pairs", one=str(len(first)),
                other=str(len(second)))  # fmt: skip
