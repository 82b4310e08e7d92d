"""Tables as Tracker, spreadsheets and loggers write them: columns of time, places or forces.

time      t, time, Zeit, temps, tiempo, 时间 (sim.measured.sheet.heads), or a unit of time; else
          the first column
position  x of each track; x_A, xA, x1, A.x; with y beside each along the track, however the film
          lay (sim.measured.sheet.turned); other columns (v_x …) are left out
force     F_A, force 2, or a unit of force
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from dataclasses import replace

from sim.measured.readers.idle import are_idle
from sim.measured.readers.no_place import no_accelerations, no_unknown_unit, no_velocities
from sim.measured.refusal import Fault, ReadingError, in_line, of_things, refuse, shown, too_few
from sim.measured.sheet.beside import check_units
from sim.measured.sheet.heads import NUMBERED, holds_times, quantity_of
from sim.measured.sheet.runs import of_one_run, run_place
from sim.measured.sheet.table import MOST_FAULTS, Column, Table, of_signs, read_table
from sim.measured.sheet.turned import along_the_track
from sim.measured.sheet.whose import cart_names, is_force, is_named, place_of
from sim.measured.track import FEWEST, Content, Reading, Track
from sim.measured.units import LETTERS, OFFERED, Kind, Units, factor, kind_of_unit
from sim.scene.said import listed, said, template

_COUNTS = re.compile(r"step|n|nr|no|#", re.I)
_FRAMES = re.compile(
    r"(?:frames?|slice|image|bild|帧|bingkai|scorer|bodyparts|coords)"  # the last are DeepLabCut's
    rf"(?:[\s_.-]*(?:{NUMBERED}|n°|#))?",
    re.I,
)

KINDS: dict[Kind, str] = {
    "time": template("time"), "length": template("length"), "force": template("force"),
}  # fmt: skip
"""In words."""


def claims(text: str) -> bool:
    """Whatever no other reader knows."""
    return True


def read(text: str, units: Units) -> Reading:
    """The tracks of a table; raises ReadingError."""
    one = of_one_run(read_table(text), units.run)
    reading = _of_table(one.table, units)
    if len(one.runs) == 1:
        run_place(units.run, one.runs)
    return replace(reading, notes=(*one.notes, *reading.notes), run=one.run, runs=one.runs)


def _of_table(table: Table, units: Units) -> Reading:
    time = _time_column(table)
    wanted, kind = _wanted(table, time)
    if not wanted:
        no_accelerations(table)
        no_unknown_unit(table)
        names = ", ".join(
            shown(f"{c.name} ({c.unit})".removesuffix(" ()")) for c in table.columns[:8]
        )
        raise refuse(
            table.heads_line,
            said("no column holds positions or forces (columns: {names})", names=names),
            said("name them x_A and x_B in m, cm or mm, or F_A and F_B in N"),
        )
    clocks = [_clock(table, column, time) for column in wanted]
    read, turned = along_the_track(table, wanted) if kind == "length" else (wanted, [])
    factors = zip(
        _factors(table, clocks, "time", units), _factors(table, wanted, kind, units), strict=True
    )
    called = cart_names([(c.name, c.unit, c.track) for c in read])
    columns = zip(called, clocks, read, factors, strict=True)
    tracks = [_track(table, *one) for one in columns]
    notes = [*_named(clocks, "time"), *_named(wanted, kind), of_signs(table), *turned]
    others = [c for c in table.columns if c not in wanted and c is not time]
    if kind == "force" and any(map(_is_place, others)):
        notes.append(said("forces were read, and positions left out"))
    elif kind == "length" and sum(is_force(c.name, c.unit) for c in others) >= 2:
        notes.append(said("positions were read: the force sensors show no push"))
    what: Content = "force" if kind == "force" else "length"
    asked: dict[Kind, list[Column]] = {"time": clocks, kind: wanted}
    assumed = frozenset(one for one, its in asked.items() if not all(c.unit for c in its))
    unnamed = len(read) == 1 and not is_named(read[0].name, read[0].unit, read[0].track)
    return Reading(what, tuple(tracks), tuple(notes), assumed=assumed, unnamed=unnamed)


def _time_column(table: Table) -> Column:
    times = [c for c in table.columns if holds_times(c.name, c.unit)]
    if times:  # a clock of whole seconds stands still between readings
        return next((column for column in times if _rises(column)), times[0])
    first, *others = table.columns
    counts = _FRAMES.fullmatch(first.name) or _COUNTS.fullmatch(first.name)
    if not counts and not _rises(first):
        counts = next(filter(None, (_FRAMES.fullmatch(one.name) for one in others)), None)
    if counts:
        reason = said(
            "no column holds the time (“{column}” counts frames)", column=shown(counts[0])
        )
        hint = said("export t as well, or add a column t (s): frame over frames a second")
        raise refuse(table.heads_line, reason, hint)
    return first


def _clock(table: Table, column: Column, first: Column) -> Column:
    """The times of a sensor that has a column of its own for them, to its left."""
    left = table.columns[: table.columns.index(column)]
    times = [c for c in left if holds_times(c.name, c.unit)]
    own = [c for c in times if column.track and c.track == column.track]
    rising = [c for c in own or times if _rises(c)]
    return rising[-1] if rising else next(iter(own), first)


def _rises(column: Column) -> bool:
    told = [value for value in column.values if value is not None]
    return all(a < b for a, b in itertools.pairwise(told))


def _wanted(table: Table, time: Column) -> tuple[list[Column], Kind]:
    """The columns with forces that show a push, else those with positions."""
    others = [c for c in table.columns if c is not time and not holds_times(c.name, c.unit)]
    forces = [c for c in others if is_force(c.name, c.unit)]
    places = [c for c in others if _is_place(c)]
    if len(forces) >= 2 and not (len(places) == 2 and are_idle(forces)):
        return _not_three(table, forces, "force"), "force"
    if not places:
        places = [c for c in others if quantity_of(c.name, c.unit)[0] == "pos" and c.unit]
    if not places and forces:  # the other sensor may stand in a file of its own
        return forces, "force"
    if not places and len(others) == 2:
        no_velocities(table, others)
        places = [c for c in others if not c.unit or kind_of_unit(c.unit) == "length"]
    return _not_three(table, places, "length"), "length"


def _is_place(column: Column) -> bool:
    fits = kind_of_unit(column.unit or "m") == "length"
    return fits and place_of(column.name) is not None


def _not_three(table: Table, columns: list[Column], kind: Content) -> list[Column]:
    if len(columns) > 2:
        names = ", ".join(shown(f"{c.track} {c.name}") for c in columns[:6])
        reason = said("{things}: {names}", things=of_things(len(columns), kind), names=names)
        raise refuse(table.heads_line, reason, said("leave two of them in the file"))
    return columns


def _named(columns: Sequence[Column], kind: Kind) -> list[str]:
    """A note of the units that the heads of these columns name."""
    own = [column.unit for column in columns]
    if not all(own):
        return []
    units = listed(list(dict.fromkeys(own)))
    return [said("{letter} in {unit} (as the file says)", letter=LETTERS[kind], unit=units)]


def _factors(table: Table, columns: Sequence[Column], kind: Kind, units: Units) -> list[float]:
    """Of the columns, to SI."""
    if kind != "time":
        check_units(table, columns, f"{LETTERS[kind]}_A ({OFFERED[kind][0]})")
    factors = []
    for column in columns:
        unit = column.unit or units.of(kind)
        found = factor(unit, kind)
        if found is None:
            reason = said(
                "“{unit}” is not a unit of {kind} (column {column})",
                unit=shown(unit),
                kind=KINDS[kind],
                column=shown(column.name),
            )
            hint = said("{kind} is in {units}", kind=KINDS[kind], units=", ".join(OFFERED[kind]))
            raise refuse(table.heads_line, reason, hint)
        factors.append(found)
    return factors


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
            reason = said("this row has a reading and no time")
            faults.append(Fault(line, reason, said("fill the time in")))
        elif kept and t <= kept[-1][0]:
            there = in_line(kept[-1][2])
            if t == kept[-1][0]:
                reason = said("the time stands in {line} already", line=there)
            else:
                reason = said("the time goes back: in {line} it was later", line=there)
            hint = said("one row for each frame, in the order of time")
            faults.append(Fault(line, reason, hint))
        else:
            kept.append((t, value, line))
    if faults:
        raise ReadingError(faults[:MOST_FAULTS])
    if len(kept) < FEWEST:
        line = kept[-1][2] if kept else table.lines[-1]
        hint = said("mark the cart in every frame, also before and after the contact")
        raise refuse(line, too_few(len(kept), name), hint)
    return Track(
        name,
        tuple(t * factors[0] for t, _, _ in kept),
        tuple(value * factors[1] for _, value, _ in kept),
        tuple(line for _, _, line in kept),
    )
