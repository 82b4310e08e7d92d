"""Reading a number with its unit and its tolerance, as they stand in a question."""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sim.lesson import units
from sim.lesson.keys import NUMBER_OR_TEXT, Key
from sim.scene.problem import Path, Problem
from sim.scene.quantity import Dimension, QuantityError, read_quantity, unit_of

PLUS_MINUS = re.compile(r"(?:±|\+/?[-−])\s*(?=[\d.])")
FIGURES = 3  # what pages show and students type
_FRACTION = re.compile(r"\s*([+-]?[\d.]+)\s*/\s*(\d+)\s*(.*)")
_DATE = re.compile(r"\d{4}-\d\d?-\d\d?.*", re.DOTALL)
TOLERANCE = Key(
    "tolerance",
    "how far from the answer is still right: with a unit, or in % of the answer",
    "0.01 m/s",
    NUMBER_OR_TEXT,
    True,
)


def read_right(
    table: Mapping[str, Any],
    measured: tuple[str, Dimension],
    path: Path,
    problems: list[Problem],
) -> tuple[Fraction, Fraction]:
    """`answer` and `tolerance`, SI, wherever a number is to be typed; a tolerance that nobody can
    meet is a problem. `measured`: what `read_unit` says of the answer."""
    before = len(problems)
    exact = read_number(table, "answer", measured[1], path, problems)
    tolerance = read_tolerance(table, exact, measured, path, problems)
    if len(problems) == before:
        _check_tolerance(table, (exact, tolerance), measured, path, problems)
    return exact, tolerance


def as_asked(right: tuple[Fraction, Fraction], measured: tuple[str, Dimension]) -> dict[str, Any]:
    """The right number and its tolerance in the unit of the answer, and all that may be typed."""
    return {
        "answer": units.tidy(right[0], *measured),
        "tolerance": units.tidy(right[1], *measured),
        "unit": measured[0],
        "units": units.factors(*measured),
    }


def read_unit(
    table: Mapping[str, Any], name: str, path: Path, problems: list[Problem]
) -> tuple[str, Dimension]:
    """The unit that stands behind a number, and what it measures; a plain number has none."""
    unit = unit_of(str(table.get(name, ""))).replace("μ", "µ")
    dimension = units.dimension_of(unit)
    if dimension is None:
        if not is_number(table, name, path, problems):  # a comma in the number is no unit
            return "", units.RATIO
        message, hint = _no_unit(str(table[name]), unit, name)
        problems.append(Problem((*path, name), "wrong-unit", message, hint))
        return "", units.RATIO
    return unit, dimension


def _no_unit(value: str, unit: str, name: str) -> tuple[str, str]:
    """What is told of a number behind which stands no unit that is known, and what to write."""
    if both := PLUS_MINUS.match(unit):
        number, spread = value.split(both[0], 1)
        whole = f"{number.strip()} {unit_of(spread)}".strip()
        message = "how far from it is still right has a key of its own, tolerance"
        return message, f"{name}: {whole}, and beside it tolerance: {spread.strip()}"
    if _DATE.fullmatch(value):
        return f"“{value[:20]}” is a date", f"write a plain number: {name}: 0.8"
    if (parts := _FRACTION.fullmatch(value)) and Fraction(parts[2]):
        decimal = float(Fraction(parts[1]) / Fraction(parts[2]))
        shown = f"{name}: {decimal:.{FIGURES}g} {parts[3]}".rstrip()
        return f"“{value[:20]}” is a fraction", f"write it with decimals: {shown}"
    spaced = units.apart(unit)
    hint = f"with a space: {spaced}" if spaced else "for example m/s, cm, N, kg, J, N s"
    return f"“{unit[:20]}” is not a unit that is known here", hint


def is_number(table: Mapping[str, Any], name: str, path: Path, problems: list[Problem]) -> bool:
    """Whether this is a number, of whatever unit; else that is told."""
    try:
        read_quantity(table[name], units.RATIO)
    except QuantityError as error:
        if error.code != "wrong-unit":
            problems.append(Problem((*path, name), error.code, error.message, error.hint))
            return False
    return True


def read_number(
    table: Mapping[str, Any], name: str, dimension: Dimension, path: Path, problems: list[Problem]
) -> Fraction:
    """The exact SI value under `name`; 0 and a problem if there is none."""
    if table.get(name) is None:
        hint = f"{name}: {dimension.example}"
        problems.append(Problem(path, "missing", f"{name} is missing", hint))
        return Fraction(0)
    try:
        return read_quantity(table[name], dimension)
    except QuantityError as error:
        value, hint = str(table[name]).strip(), error.hint
        if sign := PLUS_MINUS.match(value):
            hint = f"{name}: {value[sign.end() :]}"  # to both sides is meant anyway
        problems.append(Problem((*path, name), error.code, error.message, hint))
        return Fraction(0)


def read_tolerance(
    table: Mapping[str, Any],
    exact: Fraction,
    measured: tuple[str, Dimension],
    path: Path,
    problems: list[Problem],
) -> Fraction:
    """The SI tolerance, given with a unit or in percent of the answer; never negative.

    `measured`: the answer's unit and what it measures. Beside an answer in percent, 2 % are of the
    whole, not of the answer.
    """
    unit, dimension = measured
    if lacks_unit(table, measured, path, problems):
        return Fraction(0)
    if table.get("tolerance") is None:  # no example of its kind: 0.60 m/s would let anything pass
        hint = "tolerance: 2 %" if exact else f"tolerance: 0.01 {unit}".rstrip()
        problems.append(Problem(path, "missing", "tolerance is missing", hint))
        return Fraction(0)
    relative = _relative(table, unit)
    kind = units.RATIO if relative else dimension
    found = read_number(table, "tolerance", kind, path, problems)
    if found < 0:
        message = "a tolerance is not negative"
        problems.append(Problem((*path, "tolerance"), "out-of-range", message, "tolerance: 1 %"))
    return abs(found * exact) if relative else abs(found)


def _relative(table: Mapping[str, Any], unit: str) -> bool:
    return str(table.get("tolerance", "")).strip().endswith("%") and unit != "%"


def _check_tolerance(
    table: Mapping[str, Any],
    right: tuple[Fraction, Fraction],
    measured: tuple[str, Dimension],
    path: Path,
    problems: list[Problem],
) -> None:
    """Tells of a tolerance that allows nothing, in percent of 0, or no number that students type,
    or 0 and the other direction too."""
    exact, tolerance = right
    unit, dimension = measured
    before = len(problems)
    shown = str(table.get("tolerance", "")).strip()
    here = (*path, "tolerance")
    if not exact and _relative(table, unit) and read_quantity(shown, units.RATIO):
        message = f"{shown} of 0 is 0: no other number would be right"
        hint = f"give it as a number: tolerance: 0.01 {unit}".rstrip()
        problems.append(Problem(here, "unreachable-tolerance", message, hint))
    if exact and tolerance >= abs(exact):
        part = abs(exact) / units.size_of(unit, dimension) / 20
        message = "with this tolerance 0 is right too, and so is nearly every answer"
        hint = f"tolerance: 5 %, or tolerance: {float(part):.2g} {unit}".rstrip()
        problems.append(Problem(here, "out-of-range", message, hint))
    if len(problems) == before and not _reachable(exact, tolerance, units.size_of(unit, dimension)):
        message = f"no number of {FIGURES} figures lies within the tolerance"
        hint = "allow at least half of the last figure: tolerance: 1 %"
        problems.append(Problem(here, "unreachable-tolerance", message, hint))


def lacks_unit(
    table: Mapping[str, Any],
    measured: tuple[str, Dimension],
    path: Path,
    problems: list[Problem],
    name: str = "tolerance",
) -> bool:
    """Whether the number under `name` is plain beside one in cm/s: 1 would be 1 m/s, unseen."""
    unit, dimension = measured
    value = str(table.get(name, "")).strip()
    if units.size_of(unit, dimension) == 1 or not _plain(value):
        return False
    what = {"tolerance": "the tolerance has", "value": "this number has"}[name]
    message = f"{what} no unit, and the answer is in {unit}"
    problems.append(Problem((*path, name), "wrong-unit", message, f"{name}: {value} {unit}"))
    return True


def _plain(value: str) -> bool:
    """A number without a unit, and not 0, which is the same in all of them."""
    try:
        return not unit_of(value) and read_quantity(value, units.RATIO) != 0
    except QuantityError:
        return False


def _reachable(exact: Fraction, tolerance: Fraction, unit: Fraction) -> bool:
    """Whether a number of three figures, in this unit, lies within the tolerance."""
    answer = float(exact / unit)
    shown = float(f"{answer:.{FIGURES}g}")
    return abs(Fraction(repr(shown)) * unit - exact) <= tolerance
