"""Logs of sensor carts and motion sensors: position, velocity and acceleration of each cart.

    Time (s), Position 1 (m), Velocity 1 (m/s), Acceleration 1 (m/s²), Position 2 (m), …

Each sensor has a zero and a direction of its own. Runs stand side by side (“Run 1: Time (s)”,
“Position 1 (m) Run #2”) or below each other, where the time starts anew: the first run that is
long enough is read, or the one that was asked for, and the others are named. A sensor may have a
time column of its own, to its left. Where there is no position, the velocity is summed up
(trapezoids).
"""

from __future__ import annotations

import itertools
import re
from dataclasses import dataclass, field, replace

from sim.measured.readers import plain
from sim.measured.refusal import in_line, of_things, refuse, shown, too_few
from sim.measured.sheet.beside import check_units, no_unit
from sim.measured.sheet.heads import Quantity, has_speeds, is_time, quantity_of
from sim.measured.sheet.prefixes import parted
from sim.measured.sheet.runs import of_one_run, run_place
from sim.measured.sheet.table import Column, Table, of_signs, read_table
from sim.measured.sheet.turned import along_the_track
from sim.measured.track import FEWEST, Reading, Track
from sim.measured.units import Kind, Units, factor, plain_unit
from sim.scene.quantity import SPEED
from sim.scene.said import said

_HEAD = re.compile(r"(velocity|acceleration|geschwindigkeit)[^\n]{0,40}(?:\(|\bin\b)", re.I)


def claims(text: str) -> bool:
    """Heads with a velocity or an acceleration beside a time, or with several runs of positions."""
    lines = text[:20_000].splitlines()
    if any(has_speeds(line) and not _FORCES.search(line) for line in lines[:MOST_HEADS]):
        return True
    head = next((line for line in lines if _TIMES.search(line)), "")
    if _FORCES.search(head):
        return False
    runs = {run for run, _ in parted(re.split(r"[\t;,]", head))} - {""}
    return bool(_HEAD.search(head)) or len(runs) > 1


_TIMES = re.compile(r"\btime\b", re.I)
_FORCES = re.compile(r"force|kraft|\bF_|[(\[/]\s*[mk]?N\s*[)\]]?", re.I)
MOST_HEADS = 30
"""Lines in which the heads of a log stand."""


@dataclass(slots=True)
class _Seen:
    """What is found on the way: notes for the reader, kinds without a unit, and the runs of a
    column whose time starts anew, with the one that was read."""

    notes: list[str]
    assumed: set[Kind] = field(default_factory=set)
    run: str = ""
    runs: tuple[str, ...] = ()


def read(text: str, units: Units) -> Reading:
    """Both carts of one run, or one; raises ReadingError."""
    one = of_one_run(read_table(text), units.run)
    seen = _Seen(one.notes, run=one.run, runs=one.runs)
    found = len(one.runs) > 1 or units.run.casefold() in map(str.casefold, one.runs)
    tracks, unnamed = _tracks(one.table, replace(units, run="") if found else units, seen)
    if not tracks:
        return plain.read(text, units)
    seen.notes.append(of_signs(one.table))
    if len(one.runs) > 1:
        seen.run, seen.runs = one.run, one.runs
    return Reading(
        "length",
        tuple(tracks),
        tuple(seen.notes),
        own=True,
        unnamed=unnamed,
        run=seen.run,
        runs=seen.runs,
        assumed=frozenset(seen.assumed),
    )


def _tracks(table: Table, units: Units, seen: _Seen) -> tuple[list[Track], bool]:
    """A track for each cart, by position or else by velocity; whether the only one is unnamed."""
    time: Column | None = None
    carts: dict[str, dict[Quantity, tuple[Column, Column]]] = {}
    for column in table.columns:
        if is_time(column.name) or (time is None and factor(column.unit, "time")):
            time = column
            continue
        what, who = quantity_of(column.name, column.unit)
        if what and time is not None:
            who = column.track or who
            kept = carts.setdefault(who, {})
            if what in kept and not who:
                kept = carts.setdefault(str(len(carts) + 1), {})
            kept.setdefault(what, (time, column))
    places = {who: kept["pos"] for who, kept in carts.items() if "pos" in kept}
    by_speed = not places
    if by_speed:
        places = {who: kept["vel"] for who, kept in carts.items() if "vel" in kept}
    if len(places) > 2:
        names = ", ".join(shown(column.name) for _, column in places.values())
        reason = said("{things}: {names}", things=of_things(len(places), "length"), names=names)
        raise refuse(table.heads_line, reason, said("leave two of them"))
    columns = [column for _, column in places.values()]
    check_units(table, columns, "Velocity A (m/s)" if by_speed else "Position A (m)")
    columns, turned = (columns, []) if by_speed else along_the_track(table, columns)
    seen.notes += turned
    tracks = []
    for k, ((who, (clock, _)), column) in enumerate(zip(places.items(), columns, strict=True)):
        alone = "1" if "2" in places else "AB"[k]  # “Position” beside “Position 2”
        name = who or (alone if len(places) > 1 else "cart")
        tracks.append(_track(table, name, (clock, column), units, seen, by_speed))
    if by_speed and tracks:
        seen.notes.append(said("positions are the velocities summed up"))
    return tracks, list(places) == [""]


def _track(
    table: Table,
    name: str,
    columns: tuple[Column, Column],
    units: Units,
    seen: _Seen,
    by_speed: bool,
) -> Track:
    clock, column = columns
    seconds = factor(clock.unit or units.time, "time")
    metres = factor(column.unit or units.length, "length")  # a speed without a unit: in a second
    if by_speed and column.unit:
        speed = SPEED.units.get(plain_unit(column.unit))
        metres = None if speed is None else float(speed)
    if seconds is None or metres is None:
        wrong = clock if seconds is None else column
        hint = (
            said("time in s, ms, µs or min")
            if seconds is None
            else said("velocity in m/s, cm/s, mm/s or km/h")
            if by_speed
            else said("length in m, cm or mm")
        )
        raise no_unit(table, wrong, hint)
    if not clock.unit:
        seen.assumed.add("time")
    if not column.unit:
        seen.assumed.add("length")
    rows = [
        (t * seconds, x * metres, line)
        for t, x, line in zip(clock.values, column.values, table.lines, strict=True)
        if t is not None and x is not None
    ]
    missing = sum(t is not None for t in clock.values) - len(rows)
    rows = _one_run(rows, name, units.run, seen)
    if missing > 0 and len(rows) >= FEWEST:
        seen.notes.append(
            said("{cart}: {count} rows without a reading, left out", cart=name, count=str(missing))
        )
    if len(rows) < FEWEST:
        line = rows[-1][2] if rows else table.lines[-1]
        hint = said("let both sensors run during the whole contact")
        raise refuse(line, too_few(len(rows), name), hint)
    seen.notes += _gaps(rows, name)
    x = _summed(rows) if by_speed else tuple(value for _, value, _ in rows)
    return Track(name, tuple(t for t, _, _ in rows), x, tuple(line for _, _, line in rows))


Rows = list[tuple[float, float, int]]


def _one_run(rows: Rows, name: str, asked: str, seen: _Seen) -> Rows:
    """From where the time starts anew to the next such place; repeated times are left out. All
    named."""
    runs: list[Rows] = [[]]
    repeated = 0
    for row in rows:
        last = runs[-1][-1][0] if runs[-1] else None
        if last is not None and row[0] == last:
            repeated += 1
        elif last is not None and row[0] < last:
            runs.append([row])
        else:
            runs[-1].append(row)
    long = [run for run in runs if len(run) >= FEWEST]
    names = tuple(str(k) for k in range(1, len(long) + 1))
    place = run_place(asked, names)
    kept = long[place] if long else max(runs, key=len)
    if len(names) > max(1, len(seen.runs)):
        seen.run, seen.runs = names[place], names
    if len(runs) > 1:
        seen.notes.append(
            said(
                "the time starts anew in {lines}: {count} readings of one run are taken",
                lines=in_line(", ".join(str(run[0][2]) for run in runs[1:6] if run)),
                count=str(len(kept)),
            )
        )
    if repeated:
        seen.notes.append(
            said("{cart}: {count} repeated times, left out", cart=name, count=str(repeated))
        )
    return kept


def _gaps(rows: Rows, name: str) -> list[str]:
    """Notes of the widest gaps between readings."""
    steps = sorted(b[0] - a[0] for a, b in itertools.pairwise(rows))
    usual = steps[len(steps) // 2]
    wide = [(a, b) for a, b in itertools.pairwise(rows) if b[0] - a[0] > 3.5 * usual]
    return [
        said(
            "{cart}: no reading from {first} to {last} s ({line})",
            cart=name,
            first=f"{a[0]:.2f}",
            last=f"{b[0]:.2f}",
            line=in_line(b[2]),
        )
        for a, b in wide[:3]
    ]


def _summed(rows: Rows) -> tuple[float, ...]:
    """m. The velocity summed up by trapezoids, from 0."""
    x = [0.0]
    for (t, v, _), (s, w, _) in itertools.pairwise(rows):
        x.append(x[-1] + 0.5 * (v + w) * (s - t))
    return tuple(x)
