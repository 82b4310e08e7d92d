"""Which units an answer may be given in: everything that measures the same thing."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction
from itertools import combinations, pairwise
from typing import Any

from sim.scene import quantity
from sim.scene.notation import same_unit, written_like
from sim.scene.quantity import Dimension, unit_of

TOGETHER = {
    "momentum": ("Ns", "kgm/s", "kgms⁻¹"),
    "force": ("kgm/s²",),
    "energy": ("Nm",),
}
"""Written without a blank between two symbols. Each is named: “ms⁻¹” could be one per millisecond,
and none of these has a second meaning."""

LONGEST_TOGETHER = 8
"""Symbols that are tried apart: kgms and a few more; not all of a word."""


def _more(dimension: Dimension, *units: str) -> Dimension:
    """With other names of its SI unit."""
    return replace(dimension, units={**dimension.units, **dict.fromkeys(units, Fraction(1))})


MOMENTUM = Dimension(
    "momentum",
    "kg m/s",
    "0.3 kg m/s",
    {
        **dict.fromkeys(("kg m/s", "N s", *TOGETHER["momentum"]), Fraction(1)),
        **dict.fromkeys(("g m/s", "mN s"), Fraction(1, 1000)),
    },
)
FORCE = _more(quantity.FORCE, "kg m/s²", *TOGETHER["force"])
ENERGY = _more(quantity.ENERGY, "N m", "kg m²/s²", *TOGETHER["energy"])
"""A student may write what a named unit is made of; a scene has its name."""
RATIO = Dimension("number", "", "0.8", {"": Fraction(1), "%": Fraction(1, 100)})
DIMENSIONS = (
    quantity.MASS,
    quantity.LENGTH,
    quantity.SPEED,
    quantity.TIME,
    FORCE,
    quantity.ACCELERATION,
    quantity.STIFFNESS,
    ENERGY,
    quantity.ANGLE,
    MOMENTUM,
)
OF_QUANTITY = {
    "x": quantity.LENGTH,
    "v": quantity.SPEED,
    "a": quantity.ACCELERATION,
    "F": FORCE,
    "p": MOMENTUM,
    "t": quantity.TIME,
}
"""What can be read off a run, and how it is measured."""


def dimension_of(unit: str) -> Dimension | None:
    """The kind of quantity that `unit` measures; an empty unit is a plain number."""
    if not unit or unit == "%":
        return RATIO
    return next((d for d in DIMENSIONS if d.factor(unit) is not None), None)


def apart(unit: str) -> str:
    """A unit whose symbols stand together, with the spaces that make it one: m s⁻¹; "": none."""
    symbols = re.match(r"[A-Za-zµ]*", unit[:LONGEST_TOGETHER])
    last = len(symbols[0]) if symbols else 0
    cuts = [cut for count in (2, 1) for cut in combinations(range(1, last), count)]
    tried = (" ".join(unit[a:b] for a, b in pairwise((0, *cut, len(unit)))) for cut in cuts)
    return next((one for one in tried if dimension_of(one)), "")


def of_others(values: Iterable[Any], dimension: Dimension) -> str:
    """The unit of all these numbers, where they measure one thing, and not this; else nothing."""
    found = [unit_of(str(value)) for value in values if value is not None]
    found = [unit for unit in found if unit != "%"]  # of the answer, whatever that is
    kinds = [dimension_of(unit) for unit in found]
    if not found or kinds[0] in (None, RATIO, dimension) or any(k is not kinds[0] for k in kinds):
        return ""
    return found[0]


def factors(unit: str, dimension: Dimension) -> dict[str, float]:
    """How many `unit` each other unit is, each rounded once: for numbers that a student types.

    The units are written in the way in which the question writes its own, which comes first.
    """
    own = size_of(unit, dimension)
    found = {unit: 1.0}
    for other, size in dimension.units.items():
        if not same_unit(other, unit):
            found[written_like(unit, other)] = float(size / own)
    return found


def size_of(unit: str, dimension: Dimension) -> Fraction:
    """How many SI units one `unit` is, which `dimension` is known to have."""
    size = dimension.factor(unit)
    assert size is not None, f"{unit} is no unit of {dimension.name}"
    return size


def tidy(value: Fraction, unit: str, dimension: Dimension) -> float:
    """An SI value in `unit`, rounded once."""
    return float(value / size_of(unit, dimension))
