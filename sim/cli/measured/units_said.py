"""How the command says in which unit a column was read: given by an option, or assumed."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from sim.measured.units import OFFERED, Kind

LEFT_OPEN = " (as you say)"
"""How the readings name a unit that no file names; the page asks for it before it goes on."""

_KINDS: dict[str, Kind] = {"t": "time", "x": "length", "F": "force"}


def units_said(notes: Sequence[str], given: Collection[str]) -> tuple[str, ...]:
    """The notes; `given`: which of the options --time, --length and --force were there."""
    return tuple(_said(note, given) for note in notes)


def _said(note: str, given: Collection[str]) -> str:
    kind = _KINDS.get(note.partition(" ")[0])
    if kind is None or LEFT_OPEN not in note:
        return note
    if kind in given:
        return note.replace(LEFT_OPEN, f" (as --{kind} says)")
    *others, last = OFFERED[kind]
    units = f"{', '.join(others)} or {last}"
    return note.replace(LEFT_OPEN, f" (assumed: the file names no unit; --{kind} takes {units})")
