"""Where a power series with many digits first becomes negative.

Signs are looked at on a grid, and at the lowest point between three of its points; doubles say most
of them, and the integers of `digit_series` where rounding could change one. Then the interval is
halved, and Newton's steps end where two of them agree.
"""

from __future__ import annotations

from tests.reference.digit_row import NOTHING
from tests.reference.digit_series import BITS, Series, fixed, value

GRID = 32
ONE = 1 << BITS
NOUGHT = fixed(NOTHING)
ROUNDING = 1e-13
"""Of the sum of all terms: more than a sum of doubles is wrong by."""


def first_negative(coefficients: Series, end: int) -> int | None:
    """First zero in [0, end] where it goes on to fall, of what is not negative at 0."""
    start = next((n for n, c in enumerate(coefficients) if abs(c) > NOUGHT), None)
    if start is None:
        return None
    coefficients = coefficients[start:]
    if coefficients[0] < 0:
        return 0
    rough = [c / ONE for c in coefficients]
    last = end / ONE
    sizes = _at([abs(c) for c in rough], last)
    if rough[0] > (sizes - rough[0]) + ROUNDING * sizes:
        return None
    before = 0
    for at in _looks(rough, last):
        seen = _at(rough, at)
        point = end if at == last else int(at * ONE)
        if seen < -ROUNDING * sizes or (seen < ROUNDING * sizes and value(coefficients, point) < 0):
            return _zero(coefficients, before, point)
        before = point
    return None


def _looks(rough: list[float], last: float) -> list[float]:
    """Times at which to look for a sign: a grid, and where it seems lowest in between.

    The lowest point of its first three terms is one more: of a parabola it is the only one.
    """
    grid = [last * j / GRID for j in range(GRID + 1)]
    seen = [_at(rough, at) for at in grid]
    found = grid[1:]
    for j in range(1, GRID):
        a, b, c = seen[j - 1 : j + 2]
        if b <= a and b <= c and a + c > 2 * b:
            found.append(grid[j] + last / GRID * (a - c) / (a - 2 * b + c) / 2)
    if len(rough) > 2 and rough[2] > 0 and 0 < -rough[1] < 2 * rough[2] * last:
        found.append(-rough[1] / (2 * rough[2]))
    return sorted(found)


def _at(coefficients: list[float], t: float) -> float:
    total = 0.0
    for one in reversed(coefficients):
        total = total * t + one
    return total


def _zero(coefficients: Series, low: int, high: int) -> int:
    """Positive at `low`, negative at `high`."""
    slope = [n * c for n, c in enumerate(coefficients)][1:]
    for _ in range(20):
        low, high = _half(coefficients, low, high)
    at = (low + high) // 2
    for _ in range(10):
        rate = value(slope, at)
        if not rate:
            break
        better = at - (value(coefficients, at) << BITS) // rate
        if not low <= better <= high:
            break
        if abs(better - at) < 1 << (BITS // 8):
            return better
        at = better
    while high - low > 1:
        low, high = _half(coefficients, low, high)
    return high


def _half(coefficients: Series, low: int, high: int) -> tuple[int, int]:
    middle = (low + high) // 2
    return (low, middle) if value(coefficients, middle) < 0 else (middle, high)
