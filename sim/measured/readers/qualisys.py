"""Qualisys Track Manager's TSV: keys, then X Y Z of each marker in mm, a row for each frame.

    FREQUENCY <tab> 500
    MARKER_NAMES <tab> cart 1 <tab> cart 2
    129.242 <tab> 450.945 <tab> 398.175 <tab> …

A row of heads (`Frame Time cart 1 X …`) may stand between. A hidden marker is 0 0 0 or empty; where
all of them are hidden the line is empty, and the frame still took its time. The track lies
somewhere in the room: its direction is that in which the markers move most (the first principal
axis), + along its largest part. Two markers that change their names are changed back.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

from sim.measured.direction import Way, along, axis_of, told
from sim.measured.refusal import refuse, shown
from sim.measured.sheet import cells
from sim.measured.sheet.cells import Row
from sim.measured.track import FEWEST, Reading, Track
from sim.measured.units import Units

KEYS = ("NO_OF_FRAMES", "NO_OF_MARKERS", "MARKER_NAMES", "FILE_VERSION", "TRAJECTORY_TYPES")
MILLI = 1e-3

Point = tuple[float, float, float]
Marks = list[tuple[int, float, Point]]
"""Of one marker: line, time in s, place in mm."""


def claims(text: str) -> bool:
    """One of the keys stands at the beginning of a line of the head."""
    return any(line.startswith(KEYS) for line in text[:4000].splitlines()[:20])


def read(text: str, units: Units) -> Reading:
    """The two markers that move most along the track, each its own way; raises ReadingError."""
    head, rows = _parts(cells.rows_of(text).rows)
    names = [name for name in head.get("MARKER_NAMES", ()) if name]
    line = rows[0].line if rows else 1
    if not names or not rows:
        raise refuse(line, "no marker is named or none has frames", "export the 3D data as TSV")
    rate = _rate(head, line)
    skipped = _skipped(head, rows, 3 * len(names))
    frames = _frames(head, rows)
    times = [frame / rate for frame in frames]
    marks = [_marks(rows, skipped + 3 * k, times) for k in range(len(names))]
    seen = [(name, one) for name, one in zip(names, marks, strict=True) if len(one) >= FEWEST]
    every = frames[-1] + 1
    notes = [
        f"marker {shown(name)}: {every - len(one)} of {every} frames hidden, left out"
        for name, one in zip(names, marks, strict=True)
        if len(one) < every
    ]
    if not seen:
        raise refuse(line, f"no marker has {FEWEST} frames in which it is seen", "film again")
    axis = axis_of([point for _, one in seen for _, _, point in one])
    if len(seen) > 2:
        seen = _apart([(name, one, _track(name, one, axis)) for name, one in seen])
        axis = axis_of([point for _, one in seen for _, _, point in one])
    if len(seen) == 2 and (changed := _unchanged(seen[0][1], seen[1][1])):
        notes.append(f"the markers change their names {changed} times: changed back")
    tracks = [_track(name, one, axis) for name, one in seen]
    tracks = sorted(tracks, key=lambda t: min(t.value) - max(t.value))
    if len(names) > len(tracks):
        left = ", ".join(shown(n) for n in names if n not in {t.name for t in tracks})
        notes.append(
            f"taken are the two markers that move most, each its own way; left out: {left}"
        )
    notes.insert(0, f"motion capture, {rate:g} frames per second, mm")
    notes.append(told(axis))
    return Reading("length", tuple(tracks), tuple(notes))


def _parts(rows: Sequence[Row]) -> tuple[dict[str, tuple[str, ...]], list[Row]]:
    """Keys with their cells, and the rows of numbers."""
    head: dict[str, tuple[str, ...]] = {}
    for k, row in enumerate(rows):
        filled = [cell for cell in row.cells if not cells.is_empty(cell)]
        if filled and all(map(cells.is_number, filled)) and row.cells[0] not in KEYS:
            return head, list(rows[k:])
        if row.cells:
            head[row.cells[0].upper()] = row.cells[1:]
    return head, []


def _rate(head: dict[str, tuple[str, ...]], line: int) -> float:
    cell = (*head.get("FREQUENCY", ()), "")[0]
    rate = cells.number_of(cell) if cells.is_number(cell) else 0.0
    if not (0.0 < rate < 1e6):
        raise refuse(line, "the head names no FREQUENCY", "export the head with it")
    return rate


def _skipped(head: dict[str, tuple[str, ...]], rows: Sequence[Row], wanted: int) -> int:
    """Columns before the first marker: none, the time, or frame and time. A row in which the last
    marker is hidden is shorter."""
    if (beside := head.get("FRAME")) is not None:
        return 2 if beside and beside[0].upper().startswith("TIME") else 1
    extra = max(len(row.cells) for row in rows) - wanted
    return extra if extra in (1, 2) else 0


def _frames(head: dict[str, tuple[str, ...]], rows: Sequence[Row]) -> list[int]:
    """The number of each row's frame: of its line, empty ones counted, unless these are more than
    the head has frames (an editor may have put one behind each)."""
    stated = (*head.get("NO_OF_FRAMES", ()), "")[0]
    by_line = [row.line - rows[0].line for row in rows]
    if cells.is_number(stated) and by_line[-1] < cells.number_of(stated):
        return by_line
    return list(range(len(rows)))


def _marks(rows: Sequence[Row], column: int, times: Sequence[float]) -> Marks:
    found: Marks = []
    for row, t in zip(rows, times, strict=True):
        three = row.cells[column : column + 3]
        if len(three) < 3 or any(cells.is_empty(cell) for cell in three):
            continue
        for cell in three:
            if not cells.is_number(cell):
                raise refuse(row.line, f"“{shown(cell)}” is not a number", "X Y Z in mm")
        x, y, z = (cells.number_of(cell) for cell in three)
        if not all(map(math.isfinite, (x, y, z))):
            raise refuse(row.line, "a place is too large", "X Y Z in mm")
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
    """mm. How far both would have moved."""
    return math.dist(pair[0], last[0]) + math.dist(pair[1], last[1])


def _track(name: str, marks: Marks, axis: Way) -> Track:
    return Track(
        name,
        tuple(t for _, t, _ in marks),
        tuple(MILLI * along(axis, p) for _, _, p in marks),
        tuple(line for line, _, _ in marks),
    )
