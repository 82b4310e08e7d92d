"""What students did with runs of their own: challenges, forces that they found, readings.

Nothing here is right or wrong, so it has no key. A class in which nobody has found a contact with
unequal forces, after two hundred runs, has seen more than one that was told so.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from sim.classroom.files.keyed import KeyedForm
from sim.classroom.report.marked import Marked
from sim.classroom.report.most_said import most_said
from sim.classroom.report.settings import told_settings
from sim.lesson.answer_file import CHALLENGE, FOUND_FORCE, Item


@dataclass(frozen=True, slots=True)
class _Done:
    """What one student did: in how many runs, whether it was found, and what was set or found."""

    runs: int
    found: bool
    said: str


Made = list[tuple[Item, _Done]]


def own_run_rows(files: Sequence[Marked], form: KeyedForm | None) -> list[dict[str, Any]]:
    """One row for each challenge, each hidden force and each reading of a changed run, as met."""
    made: dict[tuple[str, str], Made] = {}
    for item in (item for file in files for item in file.file.latest().values()):
        read = KINDS.get(item.type)
        done = read(item) if read else None
        if done:
            made.setdefault((item.type, item.id), []).append((item, done))
    rows = [
        _row(kind, name, _ask(name, found, form), found) for (kind, name), found in made.items()
    ]
    return sorted(rows, key=lambda row: row.pop("first"))


def _ask(name: str, made: Made, form: KeyedForm | None) -> str:
    if form and name in form.items:
        return form.items[name].ask
    return next((item.more["asked"] for item, _ in made if item.more.get("asked")), "")


def _row(kind: str, name: str, ask: str, made: Made) -> dict[str, Any]:
    items, done = zip(*made, strict=True)
    said, more = most_said(one.said for one in done if one.said)
    return {
        "kind": kind,
        "id": name,
        "ask": ask,
        "n": len(items),
        "runs": sum(one.runs for one in done),
        "found": sum(one.found for one in done),
        "said": [{"said": words, "count": count} for words, count in said],
        "more": more,
        "first": min(item.first or "" for item in items),
    }


def _challenge(item: Item) -> _Done | None:
    value = item.value if isinstance(item.value, dict) else {}
    runs, values = value.get("runs"), value.get("values")
    if not isinstance(runs, int) or isinstance(runs, bool) or runs < 1:
        return None
    found = bool(value.get("found"))
    return _Done(runs, found, values if found and isinstance(values, str) else "")


def _force(item: Item) -> _Done:
    return _Done(item.tries, found=True, said=item.more.get("said", ""))


def _reading(item: Item) -> _Done | None:
    if not item.set:
        return None
    return _Done(1, found=False, said=told_settings(item.set))


KINDS: dict[str, Callable[[Item], _Done | None]] = {
    CHALLENGE: _challenge,
    FOUND_FORCE: _force,
    "reading": _reading,
}
