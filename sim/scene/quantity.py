"""Numbers with units: the only place where units are converted.

A quantity is a plain number (SI) or a text ``[number][space][unit]``: ``0.5``, ``500 g``,
``2 km/h``, ``1e9``. The value is kept as the exact fraction that the decimal text names, so that
0.3 − 0.1 − 0.2 is zero; it is rounded to a float once, where it is used.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache

from sim.scene.notation import same_unit, unit_meant, with_exponent
from sim.scene.problem import meant
from sim.scene.said import said

LARGEST = Fraction(10) ** 50
SMALLEST = 1 / LARGEST
"""Magnitudes outside 1e-50 to 1e50 (SI) are refused. Products of five such numbers, the longest
in the formulas, still fit a float; nothing in a school laboratory comes near either end."""

MOST_POWER = 400
"""Of ten, either way. It is far out of bounds, and the exact fraction would have as many digits."""

LONGEST_TEXT = 64
"""Characters. A number with a unit is never longer; a pasted megabyte is refused unread."""

_NUMBER = re.compile(
    r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,4})?)\s*(.*)", re.ASCII | re.DOTALL
)


class QuantityError(ValueError):
    """The text is not a quantity of the wanted kind. `code`, `message`, `hint` as in a Problem."""

    def __init__(self, code: str, message: str, hint: str) -> None:
        super().__init__(message)
        self.code, self.message, self.hint = code, message, hint


@dataclass(frozen=True, slots=True)
class Dimension:
    """A kind of quantity: its name in messages, its SI unit, an example, and the units it takes."""

    name: str
    si: str
    example: str
    units: dict[str, Fraction]

    def such_as(self, example: str) -> Dimension:
        """The same with what is usual where a key has it."""
        return replace(self, example=example)

    def factor(self, unit: str) -> Fraction | None:
        """How many SI units one `unit` is, however it is written; None: it measures another."""
        known = self.units.get(_micro(unit))
        if known is not None or not unit:
            return known
        same = (size for other, size in self.units.items() if same_unit(other, unit))
        return next(same, None)


def _dimension(name: str, example: str, **units: str) -> Dimension:
    """Units are given as factor texts; the first is the SI unit. `_per_` and `2` are spelt out."""
    table = {_spelt(unit): Fraction(factor) for unit, factor in units.items()}
    return Dimension(name, next(iter(table)), example, table)


def _spelt(unit: str) -> str:
    return _micro(unit.replace("_per_", "/"))


def _micro(unit: str) -> str:
    """One µ for the two that look the same (U+03BC, U+00B5)."""
    return unit.replace("\u03bc", "\u00b5")


MASS = _dimension("mass", "0.5 kg", kg="1", g="1/1000", mg="1/1000000", t="1000")
LENGTH = _dimension("length", "0.40 m", m="1", cm="1/100", mm="1/1000", km="1000", µm="1/1000000")
LENGTH_READ = Dimension(
    LENGTH.name, LENGTH.si, LENGTH.example,
    LENGTH.units
    | {"dm": Fraction(1, 10), "in": Fraction(127, 5000), "ft": Fraction(381, 1250)},
)  # fmt: skip
"""Of readings: some devices write inches and feet, some students dm. A scene does not."""

SPEED = _dimension(
    "velocity",
    "0.60 m/s",
    m_per_s="1",
    cm_per_s="1/100",
    mm_per_s="1/1000",
    km_per_h="5/18",
    km_per_s="1000",
)
TIME = _dimension("time", "6 s", s="1", ms="1/1000", µs="1/1000000", min="60", h="3600")
TIME_READ = Dimension(
    TIME.name, TIME.si, TIME.example, TIME.units | {"ns": Fraction(1, 10**9)}
)  # fmt: skip
"""Of readings: the clock of a phone counts so."""

FORCE = _dimension("force", "2 N", N="1", mN="1/1000", kN="1000")
STIFFNESS = _dimension(
    "stiffness", "400 N/m", N_per_m="1", N_per_cm="100", N_per_mm="1000", kN_per_m="1000"
)
HERTZ_STIFFNESS = Dimension(
    "stiffness", "N/m^1.5", "1e6 N/m^1.5", {"N/m^1.5": Fraction(1), "N/m^(3/2)": Fraction(1)}
)
ACCELERATION = Dimension(
    "acceleration",
    "m/s²",
    "9.81 m/s²",
    {
        "m/s²": Fraction(1),
        "N/kg": Fraction(1),
        "cm/s²": Fraction(1, 100),
        "mm/s²": Fraction(1, 1000),
    },
)
ANGLE = Dimension(
    "angle",
    "rad",
    "2 deg",
    {"rad": Fraction(1), "deg": Fraction(math.pi / 180), "°": Fraction(math.pi / 180)},
)
ENERGY = _dimension("energy", "0.3 J", J="1", mJ="1/1000", kJ="1000")
LINEAR_DRAG = Dimension(
    "drag",
    "kg/s",
    "0.05 kg/s",
    {"kg/s": Fraction(1), "g/s": Fraction(1, 1000), "N s/m": Fraction(1), "N·s/m": Fraction(1)},
)
QUADRATIC_DRAG = Dimension(
    "drag", "kg/m", "0.1 kg/m", {"kg/m": Fraction(1), "g/m": Fraction(1, 1000)}
)
DAMPING = Dimension(
    "damping", "N s/m", "0.5 N s/m", dict.fromkeys(("N s/m", "N·s/m", "kg/s"), Fraction(1))
)
RATIO = Dimension("number", "", "0.8", {"%": Fraction(1, 100)})
STRENGTH = Dimension("strength", "", "1e-6", {})


def read_quantity(value: object, dimension: Dimension) -> Fraction:
    """The exact SI value of `value`, an int, a float or a text.

    Raises QuantityError for anything else: a truth value, NaN, an unknown or missing number, a
    unit of another kind, a magnitude outside SMALLEST to LARGEST.
    """
    hint = said("write a number with its unit, for example {example}", example=dimension.example)
    if not dimension.si:
        hint = said("write a plain number, for example {example}", example=dimension.example)
    if isinstance(value, bool) or not isinstance(value, (int, float, str)):
        raise QuantityError("not-a-number", _no_number(_shown(value)), hint)
    if isinstance(value, float):
        if not math.isfinite(value):
            raise QuantityError("not-finite", _not_usable(str(value)), hint)
        return _bounded(exact(repr(value)), hint)
    if isinstance(value, int):
        return _bounded(Fraction(value), hint)
    return _bounded(_from_text(value, dimension, hint), hint)


@lru_cache(maxsize=4096)
def exact(number: str) -> Fraction:
    """The number that the text says. A page reads the same scene again at each move of a slider."""
    return Fraction(number)


def unit_of(text: str) -> str:
    """The unit at the end of a quantity's text, or nothing."""
    match = _NUMBER.fullmatch(with_exponent(text.strip()))
    return match.group(2).strip() if match else ""


def _from_text(text: str, dimension: Dimension, hint: str) -> Fraction:
    if len(text) > LONGEST_TEXT:
        reason = said("this text is too long to be a number")
        raise QuantityError("not-a-number", reason, hint)
    match = _NUMBER.fullmatch(with_exponent(text.strip()))
    if match is None:
        if text.strip().lstrip("+-−").lower() in {"nan", "inf", "infinity", ".nan", ".inf"}:
            raise QuantityError("not-finite", _not_usable(text.strip()), hint)
        raise QuantityError("not-a-number", _no_number(f"“{_shown(text)}”"), hint)
    number, unit = match.group(1), match.group(2).strip()
    if unit[:1].isdigit() or (unit[:1] in ",.'’_" and unit[1:2].isdigit()):
        raise QuantityError(
            "not-a-number",
            _no_number(f"“{_shown(text)}”"),
            said("write a point for the decimals and nothing between thousands: 0.5, 1000"),
        )
    factor = Fraction(1)
    if unit:
        known = dimension.factor(unit)
        if known is None:
            raise _wrong_unit(number, unit, dimension)
        factor = known
    exponent = re.search(r"[eE](.*)", number)
    if exponent and abs(int(exponent[1])) > MOST_POWER:
        reason = said("{number} is too large or too small", number=number)
        raise QuantityError("out-of-range", reason, hint)
    return exact(number) * factor


def _wrong_unit(number: str, unit: str, dimension: Dimension) -> QuantityError:
    """Of a unit that this kind does not take: which was meant, or which there are."""
    quantity = said(dimension.name)
    told = said("{unit} is not a unit of {quantity}", unit=f"“{_shown(unit)}”", quantity=quantity)
    if close := unit_meant(unit, dimension.units):
        return QuantityError("wrong-unit", told, meant(f"{number} {close}"))
    takes = said(
        "{quantity} takes {units}; for example {example}",
        quantity=quantity,
        units=", ".join(filter(None, dimension.units)) or said("no unit"),
        example=dimension.example,
    )
    return QuantityError("wrong-unit", told, takes)


def _bounded(value: Fraction, hint: str) -> Fraction:
    if value != 0 and not SMALLEST <= abs(value) <= LARGEST:
        raise QuantityError(
            "out-of-range",
            said(
                "the number is too large or too small: "
                "magnitudes from 1e-50 to 1e50 can be computed"
            ),
            hint,
        )
    return value


def _no_number(shown: str) -> str:
    return said("{number} is not a number", number=shown)


def _not_usable(shown: str) -> str:
    return said("{number} is not a usable number", number=shown)


def _shown(value: object) -> str:
    text = str(value).strip()
    return text if len(text) <= 40 else text[:37] + "…"
