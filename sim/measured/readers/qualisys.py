"""Qualisys Track Manager's TSV: keys, then X Y Z of each marker in mm, a row for each frame.

    FREQUENCY <tab> 500
    MARKER_NAMES <tab> cart 1 <tab> cart 2
    129.242 <tab> 450.945 <tab> 398.175 <tab> …

A row of heads (`Frame Time cart 1 X …`) may stand between. Where all markers are hidden the line is
empty, and the frame still took its time.
"""

from __future__ import annotations

from collections.abc import Sequence

from sim.measured.markers import Filmed, marks_of, reading_of
from sim.measured.refusal import refuse
from sim.measured.sheet import cells
from sim.measured.sheet.cells import CellRow
from sim.measured.track import Reading
from sim.measured.units import Units
from sim.scene.said import said

KEYS = ("NO_OF_FRAMES", "NO_OF_MARKERS", "MARKER_NAMES", "FILE_VERSION", "TRAJECTORY_TYPES")
UNIT = "mm"


def claims(text: str) -> bool:
    """One of the keys stands at the beginning of a line of the head."""
    return any(line.startswith(KEYS) for line in text[:4000].splitlines()[:20])


def read(text: str, units: Units) -> Reading:
    """Two of its markers; raises ReadingError."""
    head, rows = _parts(cells.rows_of(text).rows)
    names = [name for name in head.get("MARKER_NAMES", ()) if name]
    line = rows[0].line if rows else 1
    if not names or not rows:
        reason = said("no marker is named or none has frames")
        raise refuse(line, reason, said("export the 3D data as TSV"))
    rate = _rate(head, line)
    skipped = _skipped(head, rows, 3 * len(names))
    frames = _frames(head, rows)
    times = [frame / rate for frame in frames]
    markers = [(name, marks_of(rows, skipped + 3 * k, times, UNIT)) for k, name in enumerate(names)]
    return reading_of(Filmed(markers, UNIT, frames[-1] + 1, rate), line)


def _parts(rows: Sequence[CellRow]) -> tuple[dict[str, tuple[str, ...]], list[CellRow]]:
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
        reason = said("the head names no FREQUENCY")
        raise refuse(line, reason, said("export the head with it"))
    return rate


def _skipped(head: dict[str, tuple[str, ...]], rows: Sequence[CellRow], wanted: int) -> int:
    """Columns before the first marker: none, the time, or frame and time. A row in which the last
    marker is hidden is shorter."""
    if (beside := head.get("FRAME")) is not None:
        return 2 if beside and beside[0].upper().startswith("TIME") else 1
    extra = max(len(row.cells) for row in rows) - wanted
    return extra if extra in (1, 2) else 0


def _frames(head: dict[str, tuple[str, ...]], rows: Sequence[CellRow]) -> list[int]:
    """The number of each row's frame: of its line, empty ones counted, unless these are more than
    the head has frames (an editor may have put one behind each)."""
    stated = (*head.get("NO_OF_FRAMES", ()), "")[0]
    by_line = [row.line - rows[0].line for row in rows]
    if cells.is_number(stated) and by_line[-1] < cells.number_of(stated):
        return by_line
    return list(range(len(rows)))
