"""Masses and lengths with a tolerance: what is measured is never one number.

    0.50(1) kg           the digits in brackets count in the last digits of the number: ± 0.01 kg
    0.5 kg ± 0.01 kg     in its own unit; +- is ± as well
    0.5 ± 0.01 kg        one unit is for both, also in 50 cm ± 1: nobody means ± 1 m by that

A run takes the middle. The half width is for a certificate, which shows what the inputs allow.
"""

from __future__ import annotations

import re
from fractions import Fraction

from sim.scene.quantity import Dimension, QuantityError, read_quantity
from sim.scene.said import said

_BRACKETS = re.compile(
    r"\s*([+-]?\d*(?:\.(\d*))?)\((\d+)\)((?:[eE][+-]?\d{1,4})?)(.*)", re.ASCII | re.DOTALL
)
_DIGITS = re.compile(r"[\d.]\(\d+\)", re.ASCII)
_SIGNS = ("±", "+/-", "+-")
_UNIT = re.compile(r"[\d.eE+\-\s]*(.*)", re.ASCII | re.DOTALL)


def has_tolerance(value: object) -> bool:
    """Does a text say how far off the number may be?"""
    if not isinstance(value, str):
        return False
    return _DIGITS.search(value) is not None or any(mark in value for mark in _SIGNS)


def read_tolerant(value: str, dimension: Dimension) -> tuple[Fraction, Fraction]:
    """The middle and the half width, SI, exact. Raises QuantityError."""
    bracketed = _BRACKETS.fullmatch(value)
    if bracketed is not None:
        number, decimals, digits, power, unit = bracketed.groups()
        places = len(decimals or "")
        padded = digits.rjust(places + 1, "0")
        half = f"{padded[: len(padded) - places]}.{padded[len(padded) - places :]}"
        texts = f"{number}{power}{unit}", f"{half.rstrip('.')}{power}{unit}"
    else:
        mark = next((mark for mark in _SIGNS if mark in value), None)
        if mark is None:
            raise _refusal(dimension)
        first, second = (part.strip() for part in value.split(mark, 1))
        if _is_bare(first):
            first = f"{first} {_unit(second)}"
        elif _is_bare(second):
            second = f"{second} {_unit(first)}"
        texts = first, second
    middle, half_width = (read_quantity(text, dimension) for text in texts)
    if half_width < 0:
        raise _refusal(dimension)
    return middle, half_width


def _unit(text: str) -> str:
    found = _UNIT.fullmatch(text)
    return found[1] if found else ""


def _is_bare(text: str) -> bool:
    return re.fullmatch(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", text, re.ASCII) is not None


def _refusal(dimension: Dimension) -> QuantityError:
    number, _, unit = dimension.example.partition(" ")
    message = said("this is no number with a tolerance")
    hint = said(
        "for example {one} or {other}",
        one=f"{number}(1) {unit}",
        other=f"{number} {unit} ± 0.01 {unit}",
    )
    return QuantityError("not-a-number", message, hint)
