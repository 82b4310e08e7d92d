"""Vicon Nexus' CSV: a part for each kind of data, of which that of the markers is read.

    Trajectories
    120                       frames per second
    ,,carts:A,,,carts:B
    Frame,Sub Frame,X,Y,Z,X,Y,Z
    ,,mm,mm,mm,mm,mm,mm
    1,0,129.242,450.945,398.175,…

Parts before and behind it (devices, model outputs) are left alone.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import takewhile

from sim.measured.markers import Filmed, marks_of, reading_of
from sim.measured.refusal import refuse
from sim.measured.sheet import cells
from sim.measured.sheet.cells import CellRow
from sim.measured.track import Reading
from sim.measured.units import OFFERED, Units
from sim.scene.said import said

HEADS = 5
"""Rows before the first frame: the title, the rate, names, axes, units."""

_TITLE = re.compile(r"^\"?Trajectories\"?[,;\t ]*$", re.M)


def claims(text: str) -> bool:
    """A line is the title of this part."""
    return _TITLE.search(text.replace("\r", "\n")) is not None


def read(text: str, units: Units) -> Reading:
    """Two of its markers; raises ReadingError."""
    rows = cells.rows_of(text).rows
    begin = next((k for k, row in enumerate(rows) if _TITLE.fullmatch(row.first)), 0)
    heads, line = rows[begin : begin + HEADS], rows[begin].line
    frames = list(takewhile(lambda row: cells.is_number(row.first), rows[begin + HEADS :]))
    if not frames or len(heads) < HEADS:
        reason = said("no frame follows “Trajectories”")
        raise refuse(line, reason, said("export the trial as CSV again"))
    rate = cells.number_of(heads[1].first) if cells.is_number(heads[1].first) else 0.0
    if not (0.0 < rate < 1e6):
        reason = said("here the frames per second stand")
        raise refuse(heads[1].line, reason, said("a number, such as 120"))
    names = _names(heads[2])
    unit = (*heads[4].cells[2:], "")[0].lower()
    if unit not in OFFERED["length"]:
        reason = said("no unit of lengths stands here")
        raise refuse(heads[4].line, reason, said("mm, cm or m in each column"))
    first = cells.number_of(frames[0].first)
    times = [(cells.number_of(row.first) - first) / rate for row in frames]
    markers = [(name, marks_of(frames, k, times, unit)) for name, k in names]
    return reading_of(Filmed(markers, unit, len(frames), rate), frames[0].line)


def _names(row: CellRow) -> Sequence[tuple[str, int]]:
    """Each marker with the column of its X; without its subject, where no other has its name."""
    if row.first:  # a row without names is an empty line
        hint = said("label the markers, and export again")
        raise refuse(row.line, said("no marker is named"), hint)
    whole = [(cell, k) for k, cell in enumerate(row.cells) if cell]
    short = [name.rpartition(":")[2] for name, _ in whole]
    return [
        (own if short.count(own) == 1 else name, k)
        for own, (name, k) in zip(short, whole, strict=True)
    ]
