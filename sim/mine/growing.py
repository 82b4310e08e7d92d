"""What a law may compute without eating all memory: whole numbers, texts and lists have bounds.

These stand in the place of Python's own wherever a law could make something large at one stroke
(`sim.mine.bounded` puts the operators there). What it makes turn by turn is counted elsewhere.
"""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Callable, Iterable
from types import ModuleType
from typing import Any

MOST_BITS = 4_096
"""Of a whole number: more is no length, no mass and no force."""

MOST_ITEMS = 20_000
"""Of a list or a text: as many as one answer may have turns."""

WIDE = re.compile(r"\d{5}|\*")
"""In what a text is formatted with: a width beyond all lines, or one that is computed."""


def fits(sign: str, a: Any, b: Any) -> Any:
    """`b`, if a `sign` b is no larger than a law may have; else OverflowError."""
    if isinstance(a, int) and isinstance(b, int):
        if sign == "**" and b > 0 and a.bit_length() * b > MOST_BITS:
            raise OverflowError(f"{a} to the power {b}")
        if sign in ("<<", "*"):
            _small(a.bit_length() + (b.bit_length() if sign == "*" else b))
    elif sign == "*":
        items, count = (a, b) if isinstance(b, int) else (b, a)
        if isinstance(count, int) and hasattr(items, "__len__"):
            _few(len(items) * count)
    elif sign == "+" and hasattr(a, "__len__") and hasattr(b, "__len__"):
        _few(len(a) + len(b))
    elif sign == "%" and isinstance(a, str):
        if WIDE.search(a):
            raise OverflowError("a text that is too wide")
        told(b)
    return b


def few(made: Any) -> Any:
    """What was made of others with a star, if it is no longer than a law may have."""
    _few(len(made))
    return made


def told(value: Any) -> Any:
    """The value, if a text may hold it: with all that lies in it."""
    left, count = [value], 0
    while left:
        one = left.pop()
        count += len(one) if hasattr(one, "__len__") else 1
        _few(count)
        if not isinstance(one, str) and hasattr(one, "__len__"):
            left += [*one, *one.values()] if isinstance(one, dict) else one
    return value


def _few(count: int) -> None:
    if count > MOST_ITEMS:
        raise OverflowError(f"a list or text of {count}")


def _small(bits: int) -> None:
    if bits > MOST_BITS:
        raise OverflowError(f"a whole number of about {bits} bits")


def _bits(number: Any) -> int:
    return number.bit_length() if isinstance(number, int) else 0


def _operator(sign: str, act: Callable[[Any, Any], Any]) -> Callable[[Any, Any], Any]:
    def both(a: Any, b: Any) -> Any:
        return act(a, b) if type(a) is float else act(a, fits(sign, a, b))

    return both


OPERATORS: dict[str, Callable[[Any, Any], Any]] = {
    "**": _operator("**", operator.pow),
    "<<": _operator("<<", operator.lshift),
    "*": _operator("*", operator.mul),
    "+": _operator("+", operator.add),
    "%": _operator("%", operator.mod),
}


def bounded_range(*bounds: int) -> range:
    """`range`, no longer than one answer may have turns."""
    made = range(*bounds)
    if len(made) > MOST_ITEMS:
        raise OverflowError(f"range of {len(made)}")
    return made


def bounded_sum(values: Iterable[Any], /, start: Any = 0) -> Any:
    """`sum`, which would join lists, too."""
    if isinstance(start, (int, float)):
        return sum(values, start)
    for value in values:
        start = OPERATORS["+"](start, value)
    return start


class _Text(type):
    def __call__(cls, *given: Any) -> str:
        return str(*map(told, given))

    def __instancecheck__(cls, one: object) -> bool:
        return isinstance(one, str)


class BoundedText(str, metaclass=_Text):
    """`str`, also where a law asks whether something is one."""


def bounded_round(number: Any, digits: int | None = None) -> Any:
    """`round`, which takes a whole number to a power of ten where digits are below 0."""
    if isinstance(number, int) and isinstance(digits, int):
        _small(-4 * digits)
    return round(number, digits)


def bounded_math() -> ModuleType:
    """The module `math`, with bounds for what makes large whole numbers."""

    def factorial(n: int) -> int:
        _small(_bits(n) and n * _bits(n))
        return math.factorial(n)

    def comb(n: int, k: int) -> int:
        _small(_bits(n) and min(k, abs(n - k)) * _bits(n))
        return math.comb(n, k)

    def perm(n: int, k: int | None = None) -> int:
        _small(_bits(n) and (n if k is None else k) * _bits(n))
        return math.perm(n, k)

    def prod(values: Iterable[Any], *, start: Any = 1) -> Any:
        for value in values:
            start = OPERATORS["*"](start, value)
        return start

    def lcm(*values: int) -> int:
        _small(sum(map(_bits, values)))
        return math.lcm(*values)

    made = ModuleType("math")
    vars(made).update(vars(math), factorial=factorial, comb=comb, perm=perm, prod=prod, lcm=lcm)
    return made
