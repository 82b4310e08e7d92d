"""What a table holds: the motion of two carts, or the readings of two force sensors.

    time      t, time, Zeit, temps, tiempo, or a unit of time; else the first column
    position  x of each track; x_A, xA, x1, A.x; other columns (y, v_x …) are left out
    force     F_A, force 2, or a unit of force

Readings become SI here. A cart's readings are those rows in which both its cell and the time are
filled. Two files with one track each make two carts.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sim.measured.refusal import Fault, ReadingError, refuse, shown
from sim.measured.table import MOST_FAULTS, Column, Table, read_table
from sim.measured.units import OFFERED, Kind, Units, factor, kind_of_unit

FEWEST = 8
"""Readings of one cart. The model has eight unknowns for two."""

_TIME = re.compile(r"(t|time|zeit|temps|tiempo|tempo|tid|czas)", re.I)
_FORCE = re.compile(r"(.*\b)?(f|force|kraft|fuerza|forza)[\s_.-]*([a-z0-9]{0,8})", re.I)
_POSITION = re.compile(
    r"(?:x|pos|position|place|ort)[\s_.-]*(?:of\s+)?(?P<after>[a-z0-9]{0,8})"
    r"|(?P<before>[a-z][a-z0-9]{0,8})[\s_.-]+(?:x|pos|position)",
    re.I,
)
_COUNTS = re.compile(r"frame|step|n|nr|no|#|bild", re.I)
_NOT_POSITION = re.compile(r"xx|x\W?(speed|vel)", re.I)


@dataclass(frozen=True, slots=True)
class Track:
    """One cart, or one force sensor: SI, times rising."""

    name: str
    t: tuple[float, ...]  # s
    value: tuple[float, ...]  # m or N
    lines: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Measured:
    """Two tracks of one kind. Carts stand from left to right. `notes` say how they were read.

    `own`: each sensor may have a zero and a direction of its own; tracks as they stand in the file.
    """

    kind: Kind  # length or force
    tracks: tuple[Track, Track]
    notes: tuple[str, ...]
    own: bool = False

    @property
    def names(self) -> tuple[str, str]:
        """Of both."""
        return self.tracks[0].name, self.tracks[1].name


def read_measured(texts: Sequence[str], units: Units | None = None) -> Measured:
    """The readings in one text, or in two with a track each; raises ReadingError."""
    units = units or Units()
    found: list[Track] = []
    kinds: list[Kind] = []
    notes: list[str] = []
    for source, text in enumerate(texts):
        try:
            kind, tracks, said = _of_table(read_table(text), units)
        except ReadingError as error:
            raise ReadingError(error.faults, source) from None
        found += tracks
        kinds.append(kind)
        notes += [note for note in said if note not in notes]
    last = found[-1].lines[-1] if found and found[-1].lines else 1
    if len(set(kinds)) > 1:
        raise refuse(1, "one file holds positions and the other forces", "read them one by one")
    if len(found) != 2:
        what = "carts" if kinds[0] == "length" else "force sensors"
        raise refuse(
            last,
            f"readings of {len(found)} {what}: two are needed",
            "in Tracker choose both tracks before the export, or give a file for each cart",
        )
    return Measured(kinds[0], _in_order(found, kinds[0]), tuple(notes))


def _of_table(table: Table, units: Units) -> tuple[Kind, list[Track], list[str]]:
    time = _time_column(table)
    wanted, kind = _wanted(table, time)
    if not wanted:
        names = ", ".join(shown(c.name) for c in table.columns[:8]) or "none"
        raise refuse(
            table.heads_line,
            f"no column holds positions or forces (columns: {names})",
            "name them x_A and x_B, or F_A and F_B",
        )
    (time_factor,), time_note = _unit(table, [time], "time", units)
    value_factors, value_note = _unit(table, wanted, kind, units)
    tracks = [
        _track(table, name, time, column, (time_factor, si))
        for name, column, si in zip(_names(wanted), wanted, value_factors, strict=True)
    ]
    said = [f"{table.separator} between the columns, decimal {table.decimal}"]
    return kind, tracks, [time_note, value_note, *said]


def _time_column(table: Table) -> Column:
    for column in table.columns:
        if _TIME.fullmatch(column.name) or kind_of_unit(column.unit) == "time":
            return column
    first = table.columns[0]
    if _COUNTS.fullmatch(first.name):
        reason = f"no column holds the time (“{shown(first.name)}” counts frames)"
        raise refuse(table.heads_line, reason, "export t as well")
    return first


def _wanted(table: Table, time: Column) -> tuple[list[Column], Kind]:
    """The columns with forces, else those with positions."""
    others = [column for column in table.columns if column is not time]
    others = [c for c in others if not _TIME.fullmatch(c.name) and kind_of_unit(c.unit) != "time"]
    forces = [c for c in others if _FORCE.fullmatch(c.name) or kind_of_unit(c.unit) == "force"]
    if len(forces) >= 2:
        return _not_three(table, forces, "force sensors"), "force"
    places = [c for c in others if _POSITION.fullmatch(c.name) and not _NOT_POSITION.match(c.name)]
    if not places and len(others) == 2 and not forces:
        places = [c for c in others if kind_of_unit(c.unit) in (None, "length")]
    return _not_three(table, places, "carts"), "length"


def _not_three(table: Table, columns: list[Column], what: str) -> list[Column]:
    if len(columns) > 2:
        names = ", ".join(shown(f"{c.track} {c.name}") for c in columns[:6])
        raise refuse(
            table.heads_line, f"{len(columns)} {what}: {names}", "leave two of them in the file"
        )
    return columns


def _names(columns: Sequence[Column]) -> list[str]:
    """What the carts are called: by their track, by their column, or A and B."""
    found = []
    for k, column in enumerate(columns):
        match = _POSITION.fullmatch(column.name) or _FORCE.fullmatch(column.name)
        parts = [part for part in (match.groups() if match else ()) if part]
        label = column.track or (parts[-1] if parts else "" if match else column.name) or "AB"[k]
        found.append(label.strip() or "AB"[k])
    if len(found) == 2 and found[0] == found[1]:
        found = [f"{name} {k}" for k, name in enumerate(found, 1)]
    return found


def _unit(
    table: Table, columns: Sequence[Column], kind: Kind, units: Units
) -> tuple[list[float], str]:
    """SI factors of the columns, and a note for the reader."""
    own = [column.unit for column in columns]
    if kind != "time" and len(own) == 2 and bool(own[0]) != bool(own[1]):
        raise refuse(
            table.heads_line,
            "one column names its unit and the other does not",
            f"write both heads with a unit, for example x_A ({OFFERED[kind][0]})",
        )
    factors = []
    for column in columns:
        unit = column.unit or units.of(kind)
        found = factor(unit, kind)
        if found is None:
            offered = ", ".join(OFFERED[kind])
            reason = f"“{shown(unit)}” is not a unit of {kind} (column {shown(column.name)})"
            raise refuse(table.heads_line, reason, f"{kind} is in {offered}")
        factors.append(found)
    said = " and ".join(dict.fromkeys(column.unit or units.of(kind) for column in columns))
    how = "as the file says" if own[0] else "as you say"
    letter = {"time": "t", "length": "x", "force": "F"}[kind]
    return factors, f"{letter} in {said} ({how})"


def _track(
    table: Table, name: str, time: Column, column: Column, factors: tuple[float, float]
) -> Track:
    """One track in SI; times must rise."""
    faults: list[Fault] = []
    kept: list[tuple[float, float, int]] = []
    for t, value, line in zip(time.values, column.values, table.lines, strict=True):
        if value is None:
            continue
        if t is None:
            faults.append(Fault(line, "this row has a reading and no time", "fill the time in"))
        elif kept and t <= kept[-1][0]:
            same = t == kept[-1][0]
            reason = (
                f"the time {t:g} stands in line {kept[-1][2]} already"
                if same
                else f"the time goes back from {kept[-1][0]:g} to {t:g}"
            )
            faults.append(Fault(line, reason, "one row for each frame, in the order of time"))
        else:
            kept.append((t, value, line))
    if faults:
        raise ReadingError(faults[:MOST_FAULTS])
    if len(kept) < FEWEST:
        line = kept[-1][2] if kept else table.lines[-1]
        count = f"{len(kept)} readings of “{shown(name)}”: at least {FEWEST} are needed"
        raise refuse(line, count, "mark the cart in every frame, also before and after the contact")
    return Track(
        name,
        tuple(t * factors[0] for t, _, _ in kept),
        tuple(value * factors[1] for _, value, _ in kept),
        tuple(line for _, _, line in kept),
    )


def _in_order(found: Sequence[Track], kind: Kind) -> tuple[Track, Track]:
    """Carts from left to right; sensors as they stand in the file."""
    first, second = found
    if kind == "length" and _mean(first.value) > _mean(second.value):
        return second, first
    return first, second


def _mean(values: Iterable[float]) -> float:
    listed = list(values)
    return sum(listed) / len(listed)


def between(measured: Measured, begin: float | None, end: float | None) -> Measured:
    """Only the readings of a span of time; raises ReadingError if too few are left."""
    low = float("-inf") if begin is None else begin
    high = float("inf") if end is None else end
    tracks = []
    for track in measured.tracks:
        kept = [k for k, t in enumerate(track.t) if low <= t <= high]
        if len(kept) < FEWEST:
            line = track.lines[kept[-1]] if kept else track.lines[-1]
            count = f"{len(kept)} readings of “{shown(track.name)}” in this span of time"
            raise refuse(line, count, f"at least {FEWEST} are needed: choose a longer span")
        tracks.append(
            Track(
                track.name,
                tuple(track.t[k] for k in kept),
                tuple(track.value[k] for k in kept),
                tuple(track.lines[k] for k in kept),
            )
        )
    return Measured(measured.kind, (tracks[0], tracks[1]), measured.notes)
