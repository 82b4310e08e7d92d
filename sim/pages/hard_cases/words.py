"""The cells of the table of hard cases, in words. Twin of `sim/web/src/hard-words.js`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.pages.widget.numbers import short

METHODS = {"euler": "Euler", "semi-implicit": "semi-implicit Euler", "rk4": "RK4"}
VERDICTS = {
    "right": "right",
    "blows-up": "blows up",
    "passes-through": "carts pass through each other",
    "misses": "misses contacts",
    "makes-energy": "makes energy from nothing",
    "loses-energy": "loses energy",
    "sticks": "carts stick together",
    "wrong": "wrong",
}
UNITS = {"v": " m/s", "x": " m", "last": " s", "count": ""}
MOST_TOLD = 3
"""Expected numbers told one by one; of fifty carts nobody reads all."""

Wanted = Sequence[Sequence[Any]]
"""What, and how much it must be."""


def measure(what: str) -> str:
    """The name of one number of the end state."""
    kind, _, name = what.partition(".")
    if kind in ("v", "x"):
        last, minus, first = name.partition("-")
        return f"{kind} of {last} − {kind} of {first}" if minus else f"{kind} of {name}"
    names = {"warmed": "warmed the bumpers", "count": "contacts", "last": "last contact"}
    return names.get(kind, f"work of {name}" if kind == "work" else kind)


def amount(what: str, value: float, figures: int) -> str:
    """With its unit; counts in full."""
    kind = what.partition(".")[0]
    if kind == "count":
        return str(round(value))
    return short(value, figures) + UNITS.get(kind, " J")


def expected_lines(wanted: Wanted) -> list[str]:
    """What must come out."""
    lines = [f"{measure(what)}: {amount(what, value, 6)}" for what, value in wanted[:MOST_TOLD]]
    more = len(wanted) - len(lines)
    return [*lines, f"and {more} more"] if more else lines


def came_out(wanted: Wanted, got: Sequence[float | None], figures: int) -> str:
    """The number that is farthest off, and by how much; nothing if one is missing."""
    worst, error, came = "", 0.0, 0.0
    for (what, true), value in zip(wanted, got, strict=True):
        if value is None:
            return ""
        if not worst or abs(value - true) > error:
            worst, error, came = what, abs(value - true), value
    off = f"off by {amount(worst, error, 2)}" if error else "no error"
    return f"{measure(worst)}: {amount(worst, came, figures)}, {off}"


def exact_cell(wanted: Wanted, exact: Mapping[str, Any]) -> str:
    """What came out exactly."""
    return came_out(wanted, exact["got"], 6)


def stepped_cell(wanted: Wanted, stepped: Mapping[str, Any]) -> tuple[str, str]:
    """Verdict and distance of one method."""
    verdict = str(stepped["verdict"])
    told = "" if verdict == "blows-up" else came_out(wanted, stepped["got"], 3)
    return VERDICTS[verdict], told
