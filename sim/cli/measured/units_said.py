"""How the command says in which unit a column was read that names none: an option's, or assumed."""

from __future__ import annotations

from collections.abc import Collection

import click

from sim.measured.model.lasting import frame_of
from sim.measured.tracks import Measured
from sim.measured.units import LETTERS, OFFERED, Kind, Units

SLOW, FAR = 1.0, 20.0
"""s, m. No film, sensor or phone takes its readings so far apart, and no track is so long."""


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


def warn_of_assumed(measured: Measured, given: Collection[str]) -> None:
    """One line where readings in the units that were assumed are those of no carts in a school."""
    left, apart = measured.assumed.difference(given), frame_of(measured)
    if "time" in left and apart > SLOW:
        _warn(f"the readings are {apart:.3g} s apart: are their times in ms? Add --time ms")
    reach = max(max(track.value) - min(track.value) for track in measured.tracks)
    if "length" in left and reach > FAR:
        _warn(f"a cart goes {reach:.3g} m: are its places in cm or mm? Add --length cm or mm")


def _warn(what: str) -> None:
    click.echo(f"warning: {what}", err=True)
