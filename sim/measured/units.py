"""Units of readings: as the head of a column says, or as the reader says once.

Factors come from sim.scene.quantity, the only place where units are converted.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

from sim.scene.quantity import FORCE, LENGTH_READ, SPEED, TIME_READ, Dimension

Kind = Literal["time", "length", "force"]
DIMENSIONS: dict[Kind, Dimension] = {"time": TIME_READ, "length": LENGTH_READ, "force": FORCE}
OFFERED: dict[Kind, tuple[str, ...]] = {
    "time": ("s", "ms", "µs", "min"),
    "length": ("m", "cm", "mm"),
    "force": ("N", "mN", "kN"),
}
LETTERS: dict[Kind, str] = {"time": "t", "length": "x", "force": "F"}

_WRITTEN = {
    "sec": "s", "secs": "s", "second": "s", "seconds": "s", "sekunden": "s", "с": "s", "秒": "s",
    "saat": "s", "мс": "ms", "毫秒": "ms", "meter": "m", "metre": "m", "meters": "m", "metres": "m",
    "centimeters": "cm", "centimetres": "cm", "millimeters": "mm", "millimetres": "mm",
    "centimeter": "cm", "centimetre": "cm", "millimeter": "mm", "millimetre": "mm",
    "zentimeter": "cm", "milliseconds": "ms", "millisekunden": "ms", "msec": "ms",
    "millis": "ms", "us": "µs", "usec": "µs", "micros": "µs", "microseconds": "µs",
    "mikrosekunden": "µs", "微秒": "µs", "nanos": "ns", "nanoseconds": "ns", "minutes": "min",
    "minuten": "min", "分钟": "min",
    "inch": "in", "inches": "in", "foot": "ft", "feet": "ft",
    "м": "m", "米": "m", "см": "cm", "厘米": "cm", "мм": "mm", "毫米": "mm",
    "м/с": "m/s", "米/秒": "m/s", "mps": "m/s", "kmh": "km/h", "kph": "km/h",
}  # fmt: skip
"""Units as they are written out, or in other letters."""

_WIDE = str.maketrans("（）［］／：　", "()[]/: ")

_HEAD = (
    re.compile(r"(?P<name>.*?)\s*[(\[](?P<unit>[^()\[\]]{1,10})[)\]]\s*"),
    re.compile(r"(?P<name>[^/]+?)\s*/\s*(?P<unit>[^\W\d_]{1,4}(?:/s|/h|\s*s-1)?)\s*"),
    re.compile(
        r"(?P<name>.+?)\s+(?:in|en(?=\s+(?:[cm]?m|m?s)\b))\s+(?P<unit>[^\W\d_]{1,4}(?:/s|/h)?)\s*"
    ),
    re.compile(r"(?P<name>t|time|\w*\d|\w+_\w+|[xsd][a-zA-Z])[_ ](?P<unit>[cm]?m|m?s)"),
    re.compile(r"(?P<name>t|(?i:time\w*?|elapsed\w*?|clock))[_ ](?P<unit>[mun]?s|[µμ]s|min)"),
    re.compile(r"(?P<name>.+?)\s+(?P<unit>[cm]m|ms|[cm]?m/s)"),
)
_TOLD = (
    re.compile(r"(?P<name>.*?)\s*[(\[]\s*(?:in\s+)?(?P<unit>[^()\[\]]+)[)\]]"),
    re.compile(r"(?P<name>.+?)\s*,\s*(?P<unit>.+)"),
    re.compile(r"(?P<name>.+)\s+in\s+(?P<unit>.+)"),
)
"""What else is a unit if it is one that is known: “x (in cm)”, “x, cm”, “x in inches”."""

_INSIDE = re.compile(
    r"(?P<name>[^()\[\]]*[^()\[\]\s])(?P<gap>\s*)[(\[]\s*(?:in\s+)?(?P<unit>[^()\[\]]+)[)\]]"
    r"\s*(?P<who>[\w #.-]{1,12})"
)
"""Whose it is stands behind: “Position (cm) A”."""


@dataclass(frozen=True, slots=True)
class Units:
    """What a reader says of a file: what columns without a unit are in, and which of several runs
    is meant, by its name or its place from 1 (nothing: the first that is long enough)."""

    time: str = "s"
    length: str = "m"
    force: str = "N"
    run: str = ""

    def of(self, kind: Kind) -> str:
        """The unit for a kind of column."""
        return str(getattr(self, kind))


def narrow(text: str) -> str:
    """The text with brackets and signs of Chinese keyboards as those of others."""
    return text.translate(_WIDE)


@lru_cache(4096)  # every reader asks whether a file is its own, by the same cells
def head(text: str) -> tuple[str, str]:
    """Name and unit of a column's head: ("x", "cm") for “x (cm)”; an empty unit: none is there."""
    text = narrow(text).strip()
    for pattern in _TOLD:
        if (match := pattern.fullmatch(text)) and is_unit(match["unit"]):
            return _parted(match)
    if (
        (match := _INSIDE.fullmatch(text))
        and is_unit(match["unit"])
        and (match["gap"] or plain_unit(match["unit"]) != "s")  # glued: a plural, “Position(s) A”
    ):
        return f"{match['name']} {match['who']}", match["unit"].strip()
    for pattern in _HEAD:
        if match := pattern.fullmatch(text):
            return _parted(match)
    return text, ""


def _parted(match: re.Match[str]) -> tuple[str, str]:
    """“v_A in (m/s)” is “v_A”."""
    return match["name"].strip().removesuffix(" in"), match["unit"].strip()


_PER_SECOND = re.compile(r"([cdmk]?m)[\s·⋅*.]*s(?:\^?[-−]1|⁻¹)", re.I)
_SHOUTED = {"m", "cm", "mm", "s", "ms", "m/s", "cm/s", "mm/s"}
_PER_SQUARE = re.compile(r"([cm]?m)\W?s(?:\W{0,2}[2²]|⁻²)", re.I)


def is_unit(text: str) -> bool:
    """Of any quantity that is read here."""
    unit = plain_unit(text)
    return bool(kind_of_unit(unit)) or unit in SPEED.units or of_acceleration(unit) is not None


G = 9.80665
"""m/s², what loggers call g."""


def of_acceleration(unit: str) -> float | None:
    """m/s². What one such unit is; None if it is none of an acceleration."""
    unit = plain_unit(unit).lower()
    if match := _PER_SQUARE.fullmatch(unit):
        return factor(match[1], "length")
    return {"g": G, "mg": 1e-3 * G}.get(unit)


def plain_unit(unit: str) -> str:
    """A unit as the tables here write it; “CM” and “CM/S” are shouted."""
    unit = unit.strip().replace("μ", "µ")
    if match := _PER_SECOND.fullmatch(unit):
        unit = f"{match[1]}/s"
    if unit.upper() == unit and unit.lower() in _SHOUTED:
        return unit.lower()
    return _WRITTEN.get(unit.lower(), unit)


def kind_of_unit(unit: str) -> Kind | None:
    """The kind of quantity that a unit belongs to."""
    unit = plain_unit(unit)
    return next((kind for kind, one in DIMENSIONS.items() if unit in one.units), None)


def factor(unit: str, kind: Kind) -> float | None:
    """The SI value of one such unit; None if it is none of this kind."""
    found = DIMENSIONS[kind].units.get(plain_unit(unit))
    return None if found is None else float(found)
