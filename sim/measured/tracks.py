"""What the files hold: the motion of two carts, or the readings of two force sensors.

Each device's way of writing has a reader of its own (sim.measured.readers); the first one that
knows a text reads it. Readings become SI there. Two files with one track each make two carts.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from sim.measured.cart_names import called_as_carts
from sim.measured.readers import read_text
from sim.measured.refusal import ReadingError, of_readings, of_things, refuse, shown, too_large
from sim.measured.track import FEWEST, Content, Reading, Track
from sim.measured.units import LETTERS, Kind, Units
from sim.scene.said import said, template, wire

LARGEST = 1e9
"""In SI. Nothing that a class measures is larger."""

LATE = 1000.0
"""s. A recording that begins later has a clock that counts something else than the recording."""

HELD = {
    "length": template("positions"),
    "force": template("forces"),
    "acceleration": template("accelerations"),
}


@dataclass(frozen=True, slots=True)
class Measured:
    """Two tracks of one kind. Carts stand from left to right. `notes` say how they were read.

    `own`: each sensor may have a zero and a direction of its own; tracks as they stand in the file.
    `run`: the one that was read, of all `runs` that stand in the file, where there are several.
    `assumed`: the kinds of quantity whose columns name no unit. `synthetic`: a program made
    them, with the laws built in, so they are evidence for none. `two_files`: one for each track,
    whose clocks may count from two instants.
    """

    kind: Content
    tracks: tuple[Track, Track]
    notes: tuple[str, ...]
    own: bool = False
    run: str = ""
    runs: tuple[str, ...] = ()
    assumed: frozenset[Kind] = frozenset()
    synthetic: bool = False
    two_files: bool = False

    @property
    def names(self) -> tuple[str, str]:
        """Of both."""
        return self.tracks[0].name, self.tracks[1].name

    def plain(self) -> dict[str, Any]:
        """What was read, as plain values: for a page that is built, and for one that is live."""
        return {
            "kind": self.kind,
            "names": list(self.names),
            "read": [wire(note) for note in self.notes],
            "assumed": [kind for kind in LETTERS if kind in self.assumed],
            "tracks": [{"t": list(one.t), "value": list(one.value)} for one in self.tracks],
        }


def read_measured(texts: Sequence[str], units: Units | None = None) -> Measured:
    """The readings in one text, or in two with a track each; raises ReadingError."""
    units = units or Units()
    found: list[Track] = []
    kinds: list[Content] = []
    notes: list[str] = []
    readings: list[Reading] = []
    for source, text in enumerate(texts):
        try:
            reading = read_text(text, units)
            _check_sizes(reading.tracks)
        except ReadingError as error:
            raise ReadingError(error.faults, source) from None
        readings.append(reading)
        found += reading.tracks
        kinds.append(reading.kind)
        notes = list(dict.fromkeys((*notes, *reading.notes)))
    last = found[-1].lines[-1] if found and found[-1].lines else 1
    if len(set(kinds)) > 1:
        one, other, *_ = dict.fromkeys(kinds)
        reason = said(
            "one file holds {first}, another {second}", first=HELD[one], second=HELD[other]
        )
        raise refuse(1, reason, said("read one by one"))
    if len(found) != 2:
        raise _not_two(len(found), kinds[0], last)
    own = any(one.own for one in readings)
    unnamed = [track for one in readings if one.unnamed for track in one.tracks]
    found = _named(found if own else _in_order(found, kinds[0]), unnamed)
    found, more = _from_nought(called_as_carts(found))
    notes += more
    most = max(readings, key=lambda one: len(one.runs))
    assumed = frozenset[Kind]().union(*(one.assumed for one in readings))
    return Measured(
        kinds[0],
        (found[0], found[1]),
        tuple(notes),
        own,
        most.run,
        most.runs,
        assumed,
        two_files=len(texts) > 1,
    )


def _check_sizes(tracks: Iterable[Track]) -> None:
    for track in tracks:
        for value, line in zip(track.value, track.lines, strict=True):
            if not abs(value) <= LARGEST:
                raise refuse(line, *too_large(f"{value:g}"))
        if not track.t[-1] - track.t[0] <= LARGEST:
            reason = said("this recording lasts too long")
            raise refuse(track.lines[-1], reason, said("are these times?"))


def _from_nought(found: list[Track]) -> tuple[list[Track], list[str]]:
    """Times of day and seconds since 1970 count from the first reading: a float has no room for
    the microseconds that a derivative needs."""
    begin = min(one.t[0] for one in found)
    if abs(begin) < LATE:
        return found, []
    moved = [Track(o.name, tuple(t - begin for t in o.t), o.value, o.lines) for o in found]
    note = said(
        "the time counts from the first reading (in the file {begin} s)", begin=f"{begin:.12g}"
    )
    return moved, [note]


def _not_two(count: int, kind: Content, line: int) -> ReadingError:
    hint = (
        said("give the file of the phone on the other cart too")
        if kind == "acceleration"
        else said("in Tracker choose both tracks before the export, or give a file for each cart")
    )
    found = said("readings of {things}: two are needed", things=of_things(count, kind))
    return refuse(line, found, hint)


def _in_order(found: list[Track], kind: Content) -> list[Track]:
    """Carts from left to right; sensors as they stand in the file."""
    first, second = found
    if kind == "length" and _mean(first.value) > _mean(second.value):
        return [second, first]
    return found


def _named(found: list[Track], unnamed: Sequence[Track]) -> list[Track]:
    """Both with a name of their own, in their order: those of files that name none are A and B."""
    taken = {one.name for one in found if one not in unnamed}
    free = iter(letter for letter in "AB" if letter not in taken)
    found = [replace(one, name=next(free)) if one in unnamed else one for one in found]
    if found[0].name != found[1].name:
        return found
    return [replace(one, name=f"{one.name} {k}") for k, one in enumerate(found, 1)]


def _mean(values: Sequence[float]) -> float:
    return sum(values) / len(values)


def between(measured: Measured, begin: float | None, end: float | None) -> Measured:
    """Only the readings of a span of time; raises ReadingError if too few are left."""
    low = float("-inf") if begin is None else begin
    high = float("inf") if end is None else end
    tracks = []
    for track in measured.tracks:
        kept = [k for k, t in enumerate(track.t) if low <= t <= high]
        if len(kept) < FEWEST:
            line = track.lines[kept[-1]] if kept else track.lines[-1]
            count = said(
                "{readings} of “{cart}” in this span of time",
                readings=of_readings(len(kept)),
                cart=shown(track.name),
            )
            hint = said("at least {least} are needed: choose a longer span", least=str(FEWEST))
            raise refuse(line, count, hint)
        tracks.append(
            Track(
                track.name,
                tuple(track.t[k] for k in kept),
                tuple(track.value[k] for k in kept),
                tuple(track.lines[k] for k in kept),
            )
        )
    return replace(measured, tracks=(tracks[0], tracks[1]))
