"""OptiTrack Motive's CSV: facts in the first line, rows of heads, a row for each frame.

    Format Version,1.23,Take Name,carts,…,Export Frame Rate,120,…,Length Units,Meters,…
    ,,Marker,Marker,Marker,…
    ,,cart 1,cart 1,cart 1,…
    ,,Position,Position,Position,…
    Frame,Time (Seconds),X,Y,Z,…

Of a rigid body its place is read, not how it is turned. Where two bodies are named, the markers on
them and other ones are left alone.
"""

from __future__ import annotations

from collections.abc import Sequence

from sim.measured.markers import Filmed, marks_of, reading_of
from sim.measured.refusal import no_number, refuse, shown
from sim.measured.sheet import cells
from sim.measured.sheet.cells import CellRow
from sim.measured.track import Reading
from sim.measured.units import Units
from sim.scene.said import said

LENGTHS = {"meters": "m", "centimeters": "cm", "millimeters": "mm"}
BODY = "Rigid Body"
HEADS = 4
"""Rows above that of the axes: facts, kinds, names, and what is told of each."""


def claims(text: str) -> bool:
    """The first line names its version and the unit of lengths."""
    first = text.lstrip().partition("\n")[0]
    return first.startswith("Format Version") and "Length Units" in first


def read(text: str, units: Units) -> Reading:
    """Two of its bodies or markers; raises ReadingError."""
    rows = cells.rows_of(text).rows
    facts = dict(zip(rows[0].cells[::2], rows[0].cells[1::2], strict=False))
    unit = LENGTHS.get(facts.get("Length Units", "").lower())
    if unit is None:
        named = shown(facts.get("Length Units", ""))
        reason = said("“{unit}” is no unit of lengths here", unit=named)
        raise refuse(rows[0].line, reason, said("export in Meters"))
    at = next((k for k, row in enumerate(rows) if row.first == "Frame"), 0)
    frames = rows[at + 1 :]
    if at < HEADS or not frames:
        reason = said("there is no frame in it")
        raise refuse(rows[-1].line, reason, said("export the take as CSV again"))
    times = [_time(row) for row in frames]
    markers = [
        (name, marks_of(frames, column, times, unit)) for name, column in _columns(rows[1 : at + 1])
    ]
    if not markers:
        hint = said("export markers or rigid bodies with their positions")
        raise refuse(rows[at].line, said("no column holds positions"), hint)
    rate = (len(times) - 1) / (times[-1] - times[0]) if times[-1] > times[0] else 0.0
    return reading_of(Filmed(markers, unit, len(times), rate), frames[0].line)


def _columns(heads: Sequence[CellRow]) -> list[tuple[str, int]]:
    """Names with the column of their X."""
    kinds, names = heads[0].cells, heads[1].cells
    what, axes = heads[-2].cells, heads[-1].cells
    found = [
        (kinds[k], names[k], k)
        for k in range(min(map(len, (kinds, names, what))))
        if axes[k : k + 3] == ("X", "Y", "Z") and what[k] == "Position"
    ]
    bodies = [one for one in found if one[0] == BODY]
    return [(name, k) for _, name, k in (bodies if len(bodies) > 1 else found)]


def _time(row: CellRow) -> float:
    cell = (*row.cells, "", "")[1]
    if not cells.is_number(cell):
        raise refuse(row.line, no_number(cell), said("the time in s, in column 2"))
    return cells.number_of(cell)
