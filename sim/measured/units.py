"""Units of readings: as the head of a column says, or as the reader says once.

Factors come from sim.scene.quantity, the only place where units are converted.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

from sim.scene.quantity import FORCE, LENGTH, TIME, Dimension

Kind = Literal["time", "length", "force"]
DIMENSIONS: dict[Kind, Dimension] = {"time": TIME, "length": LENGTH, "force": FORCE}
OFFERED: dict[Kind, tuple[str, ...]] = {
    "time": ("s", "ms"),
    "length": ("m", "cm", "mm"),
    "force": ("N", "mN", "kN"),
}

_HEAD = (
    re.compile(r"(?P<name>.*?)\s*[(\[](?P<unit>[^()\[\]]{1,8})[)\]]\s*(?:run\W*\d*)?\s*", re.I),
    re.compile(r"(?P<name>[^/]+?)\s*/\s*(?P<unit>[A-Za-zµμ]{1,3})\s*"),
    re.compile(r"(?P<name>.+?)\s+in\s+(?P<unit>[A-Za-zµμ]{1,3})\s*"),
)


@dataclass(frozen=True, slots=True)
class Units:
    """What a reader says of a file: what columns without a unit are in, and which of several runs
    is meant, from 1 (0: the first that is long enough)."""

    time: str = "s"
    length: str = "m"
    force: str = "N"
    run: int = 0

    def of(self, kind: Kind) -> str:
        """The unit for a kind of column."""
        return str(getattr(self, kind))


def head(text: str) -> tuple[str, str]:
    """Name and unit of a column's head: ("x", "cm") for “x (cm)”; an empty unit: none is there.

    What a logger says of the run (“Run 1: Force (N)”, “Force (N) Run #1”) is left out.
    """
    text = text.rpartition(":")[2] or text
    for pattern in _HEAD:
        if match := pattern.fullmatch(text.strip()):
            return match["name"].strip(), match["unit"].strip()
    return text.strip(), ""


def kind_of_unit(unit: str) -> Kind | None:
    """The kind of quantity that a unit belongs to."""
    for kind, dimension in DIMENSIONS.items():
        if unit.replace("μ", "µ") in dimension.units:
            return kind
    return None


def factor(unit: str, kind: Kind) -> float | None:
    """The SI value of one such unit; None if it is none of this kind."""
    found = DIMENSIONS[kind].units.get(unit.replace("μ", "µ"))
    return None if found is None else float(found)
