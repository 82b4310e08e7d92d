"""Two numbers side by side, with as many digits as it takes to see that they differ."""

from __future__ import annotations

from collections.abc import Callable

LARGE = 1e6
"""m/s or m. What is larger is told with a power of ten."""

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
    return f"{_decimal(v, digits)} m/s"


def place(x: float, digits: int) -> str:
    """Where a cart is; a sentence says that it ends with it."""
    return f"x = {_decimal(x, digits)} m"


def _decimal(value: float, digits: int) -> str:
    return f"{value:.{digits}f}" if abs(value) < LARGE else f"{value:.{digits}g}"


def both(first: float, second: float, write: Write) -> tuple[str, str]:
    """The texts of two numbers that differ."""
    written = [
        (_signed(write(first, digits)), _signed(write(second, digits)))
        for digits in range(USUAL, MOST + 1)
    ]
    return next((texts for texts in written if texts[0] != texts[1]), written[0])


def _signed(text: str) -> str:
    return text.replace("-", "\N{MINUS SIGN}")
