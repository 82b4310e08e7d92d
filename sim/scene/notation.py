"""How numbers and units are written: schools differ, and all of them are right.

    m/s²   m/s^2   m s⁻²   m s^-2   m·s-2   m/s/s          one unit
    8e-1   8×10⁻¹   8 x 10^-1   8·10**-1                   one number

A unit is a product of symbols with powers; a stroke divides by the next symbol alone. The page
reads in the same way (sim/web/src/question/marking/notation.js; tests/marking holds them equal).
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from fractions import Fraction
from functools import lru_cache

SUPERSCRIPT = str.maketrans("0123456789-+", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺")
"""`"10" + str(power).translate(SUPERSCRIPT)` is a power of ten as readers write it."""
_PLAIN = {raised: chr(plain) for plain, raised in SUPERSCRIPT.items()}
_MINUS = str.maketrans({"−": "-", "‐": "-", "‑": "-", "–": "-", "\u03bc": "\u00b5"})
_FACTOR = re.compile(
    r"\s*(?P<join>[/·⋅*.]?)\s*(?P<symbol>[A-Za-zµ°%]+)"
    r"(?:(?P<raised>[⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)"
    r"|(?:\^|\*\*)\(?(?P<power>[+-]?\d(?:\.\d|/\d)?)\)?|(?P<plain>[+-]?\d))?"
)
_POWER_OF_TEN = re.compile(
    r"\s*[×xX*·]\s*10(?:(?P<raised>[⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,3})"
    r"|\s*(?:\^|\*\*)\s*(?P<power>\(?[+-]?\d{1,3}\)?))"
)
_LONGEST = 30


@lru_cache(maxsize=512)
def factors(unit: str) -> tuple[tuple[str, Fraction], ...] | None:
    """The symbols of a unit with their powers, sorted; None where it cannot be read."""
    text, at = unit.strip().translate(_MINUS), 0
    if not text or len(text) > _LONGEST:
        return None
    powers: dict[str, Fraction] = {}
    while at < len(text):
        found = _FACTOR.match(text, at)
        if found is None or (at == 0 and found["join"] not in ("", None)):
            return None
        raised = (found["raised"] or "").translate(_PLAIN)
        power = Fraction(raised or found["power"] or found["plain"] or "1")
        sign = -1 if found["join"] == "/" else 1
        powers[found["symbol"]] = powers.get(found["symbol"], Fraction(0)) + sign * power
        at = found.end()
    return tuple(sorted(powers.items()))


def same_unit(one: str, other: str) -> bool:
    """Whether two texts are one unit, written in two ways."""
    return one == other or (factors(one) is not None and factors(one) == factors(other))


_IN_WORDS = {
    "ton": "t", "tonne": "t", "kilogram": "kg", "kilo": "kg", "gram": "g", "second": "s",
    "sec": "s", "minute": "min", "hour": "h", "hr": "h", "meter": "m", "metre": "m",
    "centimeter": "cm", "centimetre": "cm", "millimeter": "mm", "millimetre": "mm",
    "kilometer": "km", "kilometre": "km", "newton": "N", "joule": "J", "mps": "m/s", "kmh": "km/h",
    "kph": "km/h", "degree": "deg", "percent": "%",
}  # fmt: skip
"""Units as authors write them out."""


def unit_meant(written: str, units: Iterable[str]) -> str | None:
    """The one of these units that was meant by its name, or by its sign in letters of another size.
    M is mega where it stands before a unit, and m a thousandth: neither is meant by the other."""
    small = written.casefold()
    named = _IN_WORDS.get(small) or _IN_WORDS.get(small.removesuffix("s"))
    found = [one for one in units if one == named or (one and one.casefold() == small)]
    mega = written[:1] == "M" and len(written) > 1 and "/" not in written[:2]
    return (
        found[0]
        if len(found) == 1 and not (mega and found[0] != named and found[0][0] == "m")
        else None
    )


def with_exponent(text: str) -> str:
    """The text with a power of ten as programs write it: 8×10⁻¹ becomes 8e-1."""

    def exponent(match: re.Match[str]) -> str:
        return "e" + (match["raised"] or match["power"]).translate(_PLAIN).strip("()")

    return _POWER_OF_TEN.sub(exponent, text.translate(_MINUS), count=1)


def number(value: float, places: int = 2) -> str:
    """A number as it is written here: with a real minus, and no minus before nought."""
    text = f"{value:.{places}f}"
    return f"{0:.{places}f}" if float(text) == 0 else text.replace("-", "−")


def written_like(unit: str, other: str) -> str:
    """`other` in the way in which `unit` is written: with negative powers or with strokes."""
    if not re.search(r"[⁻]|\^-|\*\*-|[a-zA-Z]-\d", unit.translate(_MINUS)) or "/" not in other:
        return other
    raised = "⁻" in unit
    head, *below = re.split(r"/", other)
    parts = []
    for part in below:
        found = re.fullmatch(r"([A-Za-zµ°%]+)(?:[\^]?([\d²³]))?", part)
        if found is None:
            return other
        power = (found[2] or "1").translate(_PLAIN)
        up = power.translate(SUPERSCRIPT)
        parts.append(f"{found[1]}{'⁻' + up if raised else '^-' + power}")
    return " ".join([head, *parts])
