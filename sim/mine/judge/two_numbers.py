"""Two numbers side by side, with as many digits as it takes to see that they differ."""

from __future__ import annotations

from collections.abc import Callable

FAST = 1e6
"""m/s. Faster is told with a power of ten."""

USUAL = 4
"""Digits."""

MOST = 12
"""Digits. What agrees in so many is equal but for rounding, and told with the usual ones."""

Write = Callable[[float, int], str]
"""A number with so many digits, and its unit."""


def newton(force: float, digits: int) -> str:
    """A force."""
    return f"{force:.{digits}g} N"


def joule(energy: float, digits: int) -> str:
    """An energy."""
    return f"{energy:.{digits}g} J"


def speed(v: float, digits: int) -> str:
    """A velocity."""
    return f"{v:.{digits}f} m/s" if abs(v) < FAST else f"{v:.{digits}g} m/s"


def place(x: float, digits: int) -> str:
    """Where a cart is; a sentence says that it ends with it."""
    return f"x = {x:.{digits}f} m" if abs(x) < FAST else f"x = {x:.{digits}g} m"


def both(first: float, second: float, write: Write) -> tuple[str, str]:
    """The texts of two numbers that differ."""
    for digits in range(USUAL, MOST + 1):
        texts = _signed(write(first, digits)), _signed(write(second, digits))
        if texts[0] != texts[1]:
            return texts
    return _signed(write(first, USUAL)), _signed(write(second, USUAL))


def _signed(text: str) -> str:
    return text.replace("-", "\N{MINUS SIGN}")
