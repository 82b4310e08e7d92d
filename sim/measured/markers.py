"""Markers that cameras follow through a room: X Y Z of each, in all frames in which it is seen.

The track lies somewhere in the room: its direction is that in which the markers move most (the
first principal axis), + along its largest part. Of several markers the two are taken that move
most, each its own way. Two markers that change their names are changed back.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass

from sim.measured.direction import Vector, along, axis_of, direction_note
from sim.measured.refusal import no_number, refuse, shown
from sim.measured.sheet import cells
from sim.measured.sheet.cells import CellRow
from sim.measured.track import FEWEST, Reading, Track
from sim.measured.units import factor
from sim.scene.said import said

Point = tuple[float, float, float]
Marks = list[tuple[int, float, Point]]
"""Of one marker: line, time in s, place in the file's unit."""


@dataclass(frozen=True, slots=True)
class Filmed:
    """What a file holds. `unit`: of its places, one of `OFFERED`; `frames`: seen or not."""

    markers: Sequence[tuple[str, Marks]]
    unit: str
    frames: int
    rate: float


def reading_of(filmed: Filmed, line: int) -> Reading:
    """The two markers that move most along the track, each its own way; raises ReadingError."""
    names = [name for name, _ in filmed.markers]
    seen = [(name, one) for name, one in filmed.markers if len(one) >= FEWEST]
    notes: list[str] = [
        said(
            "marker {name}: {hidden} of {frames} frames hidden, left out",
            name=shown(name),
            hidden=str(filmed.frames - len(one)),
            frames=str(filmed.frames),
        )
        for name, one in filmed.markers
        if len(one) < filmed.frames
    ]
    _check_times(seen)
    if not seen:
        reason = said("no marker has {least} frames in which it is seen", least=str(FEWEST))
        raise refuse(line, reason, said("film again"))
    metres = factor(filmed.unit, "length")
    assert metres is not None
    axis = axis_of([point for _, one in seen for _, _, point in one])
    if len(seen) > 2:
        seen = _apart([(name, one, _track(name, one, axis, metres)) for name, one in seen])
        axis = axis_of([point for _, one in seen for _, _, point in one])
    if len(seen) == 2 and (changed := _unchanged(seen[0][1], seen[1][1])):
        notes.append(
            said("the markers change their names {times} times: changed back", times=str(changed))
        )
    tracks = [_track(name, one, axis, metres) for name, one in seen]
    tracks = sorted(tracks, key=lambda t: min(t.value) - max(t.value))
    if len(names) > len(tracks):
        left = ", ".join(shown(n) for n in names if n not in {t.name for t in tracks})
        notes.append(
            said(
                "taken are the two markers that move most, each its own way; left out: {names}",
                names=left,
            )
        )
    rate = f"{filmed.rate:g}"
    notes.insert(
        0,
        said("motion capture, {rate} frames per second, {unit}", rate=rate, unit=filmed.unit),
    )
    notes.append(direction_note(axis))
    return Reading("length", tuple(tracks), tuple(notes))


def _check_times(markers: Sequence[tuple[str, Marks]]) -> None:
    for _, marks in markers:
        for (_, before, _), (line, t, _) in itertools.pairwise(marks):
            if not (before < t < math.inf):
                hint = said("one row for each frame, in order")
                raise refuse(line, said("the time goes back"), hint)


def marks_of(rows: Sequence[CellRow], column: int, times: Sequence[float], unit: str) -> Marks:
    """Of the marker whose X stands in this column; hidden it is 0 0 0 or empty."""
    found: Marks = []
    hint = said("X Y Z in {unit}", unit=unit)
    for row, t in zip(rows, times, strict=True):
        three = row.cells[column : column + 3]
        if len(three) < 3 or any(cells.is_empty(cell) for cell in three):
            continue
        for cell in three:
            if not cells.is_number(cell):
                raise refuse(row.line, no_number(cell), hint)
        x, y, z = (cells.number_of(cell) for cell in three)
        if not all(map(math.isfinite, (x, y, z))):
            raise refuse(row.line, said("a place is too large"), hint)
        if (x, y, z) != (0.0, 0.0, 0.0):
            found.append((row.line, t, (x, y, z)))
    return found


def _apart(seen: Sequence[tuple[str, Marks, Track]]) -> list[tuple[str, Marks]]:
    """Of several markers two that both move, and against each other: not one that lies on the
    floor, and not two of one cart."""

    def moves(pair: tuple[int, int]) -> float:
        first, second = (seen[k][2] for k in pair)
        there = dict(zip(second.t, second.value, strict=True))
        between = [x - there[t] for t, x in zip(first.t, first.value, strict=True) if t in there]
        return min(_range(first.value), _range(second.value), _range(between))

    best = max(itertools.combinations(range(len(seen)), 2), key=moves)
    return [(seen[k][0], seen[k][1]) for k in best]


def _range(values: Sequence[float]) -> float:
    return max(values) - min(values) if values else 0.0


def _unchanged(first: Marks, second: Marks) -> int:
    """Gives both markers their own places back, frame by frame; how often names were changed."""
    places = {t: k for k, (_, t, _) in enumerate(second)}
    changed, swapped = 0, False
    last: tuple[Point, Point] | None = None
    for i, (line, t, here) in enumerate(first):
        k = places.get(t)
        if k is None:
            continue
        pair = (second[k][2], here) if swapped else (here, second[k][2])
        if last and _way(pair[::-1], last) < 0.5 * _way(pair, last):
            pair, swapped, changed = pair[::-1], not swapped, changed + 1
        first[i], second[k] = (line, t, pair[0]), (second[k][0], t, pair[1])
        last = pair
    return changed


def _way(pair: tuple[Point, Point], last: tuple[Point, Point]) -> float:
    """How far both would have moved, in the file's unit."""
    return math.dist(pair[0], last[0]) + math.dist(pair[1], last[1])


def _track(name: str, marks: Marks, axis: Vector, metres: float) -> Track:
    return Track(
        name,
        tuple(t for _, t, _ in marks),
        tuple(metres * along(axis, p) for _, _, p in marks),
        tuple(line for line, _, _ in marks),
    )
