"""What a student typed as a number. The same rules as sim/web/src/typed.js, held by tests/marking.

A decimal comma is fine. “1,000” is refused with both readings, because it has two.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping

LONGEST = 40
_GROUPED = re.compile(r"([+-]?[1-9]\d{0,2}(?:,\d{3})+)(?![\d,])", re.ASCII)
_NUMBER = re.compile(r"([+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?)\s*(.*)", re.ASCII)
_MINUS = str.maketrans({"−": "-", "–": "-"})


def read_typed(typed: str, units: Mapping[str, float]) -> float | str:
    """The number in the question's own unit, or what to tell the student.

    `units` says how many of the question's unit each allowed unit is. Without a unit the number
    counts in the question's own.
    """
    text = typed.strip().translate(_MINUS)
    if not text:
        return "Type a number, for example 0.5"
    if len(text) > LONGEST:
        return "That is too long for a number."
    if grouped := _GROUPED.match(text):
        return _two_readings(grouped[1])
    match = _NUMBER.fullmatch(text)
    if match is None:
        return f"“{text}” is not a number. Type for example 0.5"
    number, unit = match[1], match[2]
    factor = units.get(unit.replace("μ", "µ")) if unit else 1.0
    if factor is None:
        return f"“{unit}” does not fit here. Units: {', '.join(u for u in units if u)}"
    value = float(number.replace(",", ".")) * factor
    return value if math.isfinite(value) else f"{text} is too large."


def _two_readings(text: str) -> str:
    whole = text.replace(",", "")
    if text.count(",") > 1:
        return f"Type {whole} without commas."
    decimal = f"{float(text.replace(',', '.')):g}"
    return f"{text} can mean {decimal} or {whole}: type {decimal} or {whole}"
