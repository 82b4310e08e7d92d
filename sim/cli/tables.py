"""Runs as text: tables for people, columns for spreadsheets."""

from __future__ import annotations

import unicodedata
from collections.abc import Sequence
from typing import Any

from sim.dynamics.report.document import energy_parts
from sim.dynamics.report.warnings import warnings
from sim.dynamics.result.finished import Run
from sim.dynamics.result.trajectory import Trajectory
from sim.scene.model import Track
from sim.scene.track import SIDES, WALL, body_name, named_ends

UNITS = {"t": "s", "x": "m", "v": "m/s", "a": "m/s²", "F": "N", "on": "N"}
NAMES = {"kinetic": "in motion", "bumpers": "in bumpers", "incline": "height on the incline"}
MOST_LINES = 200
"""Events listed for people; the rest is counted. `--json` lists them all."""


def table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Aligned columns; numbers to the right, words to the left."""
    widths = [max(columns_of(row[k]) for row in [header, *rows]) for k in range(len(header))]
    lines = []
    for row in [header, *rows]:
        cells = [
            _padded(cell, width, right=_is_number(rows, k))
            for k, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        lines.append("  ".join(cells).rstrip())
    return "\n".join(lines)


def columns_of(text: str) -> int:
    """How many columns of a terminal a text takes: Chinese letters two, marks on a letter none."""
    return sum(
        0
        if unicodedata.category(c) in ("Mn", "Me")
        else 1 + (unicodedata.east_asian_width(c) in "WF")
        for c in text
    )


def _padded(cell: str, width: int, *, right: bool) -> str:
    space = " " * (width - columns_of(cell))
    return f"{space}{cell}" if right else f"{cell}{space}"


def _is_number(rows: Sequence[Sequence[str]], k: int) -> bool:
    return all(
        row[k].lstrip("−").replace(".", "").replace("e−", "").replace("e+", "").isdigit()
        or row[k] in ("", "–")
        for row in rows
    )


def number(value: float | None) -> str:
    """Six figures; what rounding leaves of nought is nought."""
    if value is None:
        return "–"
    return f"{0.0 if abs(value) < 1e-15 else value:.6g}".replace("-", "−")


def run_as_text(run: Run) -> str:
    """What `carts run` prints for people."""
    scene = run.scene
    parts = [scene.title] if scene.title else []
    parts += [f"Warning: {warning.message}" for warning in warnings(run)]
    if run.record.keep_events:
        parts.append(_events(run))
    else:
        counts = ", ".join(f"{count} {kind}" for kind, count in run.record.counts.items())
        parts.append(f"Events: {counts}")
    rows = [
        (
            cart.name,
            number(cart.mass),
            number(cart.position),
            number(cart.velocity),
            number(x),
            number(v),
        )
        for cart, x, v in zip(scene.carts, run.x, run.v, strict=True)
    ]
    parts.append(table(("cart", "m kg", "x0 m", "v0 m/s", "x m", "v m/s"), rows))
    parts.append(_account(run))
    parts.append(run.outcome.sentence)
    return "\n\n".join(parts)


def _account(run: Run) -> str:
    """Momentum and energy at both ends, and what every change is due to."""
    ledger = run.ledger
    rows = [("momentum N s", ledger.momentum_initial, ledger.momentum_final)]
    rows += [("energy J", ledger.energy_initial, ledger.energy_final)]
    parts = energy_parts(run)
    if len(parts) > 2 or any(value for value in parts["bumpers"].values()):
        rows += [(f"  {NAMES.get(n, n)}", p["initial"], p["final"]) for n, p in parts.items()]
    lines = [table(("", "start", "end"), [(n, number(a), number(b)) for n, a, b in rows])]
    given = [
        f"{_giver(by, run.scene.track)} gave {number(j)} N s" for by, j in ledger.impulses.items()
    ]
    lines.append(f"From outside: {', '.join(given)}." if given else "No impulse from outside.")
    works = [f"{by} {number(work)} J" for by, work in ledger.works.items()]
    lines += [f"Work: {', '.join(works)}."] if works else []
    touching = [contact for contact in run.scene.contacts if contact is not None]
    if touching or ledger.warmed:  # what friction warmed stands among the works
        sudden = all(contact.sudden for contact in touching)
        where = "became heat in contacts" if sudden else "warmed the bumpers"
        lines.append(f"{number(ledger.warmed)} J {where}.")
    return "\n".join(lines)


def _giver(by: str, track: Track) -> str:
    """Walls by what stands there, where it is something else."""
    if by != "walls" or not named_ends(track):
        return by
    sides = [side for side in SIDES if getattr(track, side) == WALL]
    return " and ".join(body_name(side, track) for side in sides)


def _events(run: Run) -> str:
    rows = []
    for event in run.record.events[:MOST_LINES]:
        speeds = " ".join(f"{name} {number(v)}" for name, v in event.after.items())
        rows.append(
            (
                number(event.t),
                event.kind,
                " ".join(event.bodies),
                number(event.impulse),
                number(event.force),
                speeds,
            )
        )
    text = table(("t s", "event", "bodies", "impulse N s", "force N", "velocities m/s"), rows)
    more = len(run.record.events) - len(rows)
    return f"{text}\n… and {more} more (--json lists them all)" if more > 0 else text


def columns_as_csv(samples: Trajectory) -> bytes:
    """The sampled motion, one column each, unit in the header; lines end as RFC 4180 says.

    Bytes: Windows would write each end of a line twice.
    """
    columns = {name: values for name, values in samples.columns.items() if name[0] in UNITS}
    header = ",".join(f"{' '.join(name)} ({UNITS[name[0]]})" for name in columns)
    lines = (",".join(repr(value) for value in row) for row in zip(*columns.values(), strict=True))
    return "\r\n".join([header, *lines, ""]).encode()


def certificate_as_text(found: dict[str, Any]) -> str:
    """What `carts run --certify` prints for people: bounds of the end, and what is not proved."""
    if not found["final"]["x"]:
        return f"No certificate: {found['reason']}."
    units = {"x": "m", "v": "m/s"}
    rows = [
        (f"{kind} {name}", low, high, units[kind])
        for kind, carts in found["final"].items()
        for name, (low, high) in carts.items()
    ]
    parts = ["Proved, with every rounding outwards:"]
    parts.append(table(("", "not less than", "not more than", ""), rows))
    events = [
        (event["kind"], " ".join(event["bodies"]), *event["t"], "s") for event in found["events"]
    ]
    parts.append(table(("event", "", "not before", "not after", ""), events[:MOST_LINES]))
    if found["order"] == "proved":
        parts.append("The order of the events is proved.")
    else:
        parts.append(f"The order of the events is not proved: {found['reason']}.")
    return "\n".join(parts)
