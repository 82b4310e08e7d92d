"""How the command says in which unit a column was read that names none: an option's, or assumed."""

from __future__ import annotations

from collections.abc import Collection

from sim.measured.units import LETTERS, OFFERED, Kind, Units


def units_said(assumed: Collection[Kind], units: Units, given: Collection[str]) -> tuple[str, ...]:
    """A sentence for each kind of column without a unit; `given`: which of the options --time,
    --length and --force were there."""
    return tuple(_said(kind, units.of(kind), kind in given) for kind in LETTERS if kind in assumed)


def _said(kind: Kind, unit: str, given: bool) -> str:
    letter = LETTERS[kind]
    if given:
        return f"{letter} in {unit} (as --{kind} says)"
    *others, last = OFFERED[kind]
    offered = f"{', '.join(others)} or {last}"
    return f"{letter} in {unit} (assumed: the file names no unit; --{kind} takes {offered})"
