"""The sums of one item in one group, from counts of students by what they answered."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from sim.classroom.report.items.statistics import add_difficulty
from sim.classroom.statistics.item_numbers import ItemMarks
from sim.classroom.statistics.spread import Exact
from sim.classroom.summary.sums import ItemSums
from sim.country.cells import Cell
from sim.country.rows import BETWEEN
from sim.lesson.csv_text import safe_text
from sim.lesson.read import KINDS

UNMARKED = frozenset(name for name, kind in KINDS.items() if not kind.MARKED)
"""What else is open, in an optional part too, is to be read."""


def item_sums_of(
    cells: Sequence[Cell], meta: Mapping[str, Any], listed: int, *, counted: bool, keyed: bool
) -> ItemSums:
    """`listed`: students of the group; `counted`: the item is part of the total.

    Marks are of those who have a total: what the others had, `difficulty_of_all` says.
    """
    with_total = [cell for cell in cells if counted and not cell["sheet_foreign"]]
    return ItemSums(
        counts=_counts(cells, meta, listed, keyed=keyed),
        chosen=_chosen(cells, meta),
        sure=_chosen([cell for cell in cells if cell["certain"]], meta),
        marks=_marks(with_total),
        levels=_levels(with_total),
        options=None,
    )


def difficulty_of_all(
    rows: Sequence[dict[str, Any]], counted: Sequence[str], cells: Sequence[Cell]
) -> None:
    """Says the difficulty of items anew, of everybody who answered."""
    for row in rows:
        if row["id"] not in counted:
            continue
        mine = [c for c in cells if c["keyed"] and c["item"] == row["id"]]
        n, m = sum(c["n"] for c in mine), sum(c["n"] * (c["marks"] or 0) for c in mine)
        others = row["notes"][row["difficulty"] is None :]  # its own is the first
        row |= {"difficulty": None, "notes": []}
        add_difficulty(row, n, m, row["worth"])
        row["notes"] += others


def _counts(
    cells: Sequence[Cell], meta: Mapping[str, Any], listed: int, *, keyed: bool
) -> dict[str, int]:
    verdicts: Counter[str] = Counter()
    sure: Counter[str] = Counter()
    n = answered = 0
    for cell in cells:
        n += cell["n"]
        answered += cell["n"] * bool(cell["answered"])
        verdicts[cell["verdict"] or ""] += cell["n"]
        if cell["certain"] and cell["answered"]:
            sure[cell["verdict"] or ""] += cell["n"]
    return {
        "n": n, "answered": answered, "right": verdicts["right"], "partly": verdicts["partly"],
        "wrong": verdicts["wrong"] + verdicts["unclear"],
        "empty": verdicts["empty"] if keyed else listed - n,
        "unread": 0 if meta["type"] in UNMARKED else verdicts["open"],
        "sure_right": sure["right"] if meta["sure"] else 0,
        "sure_wrong": sure["wrong"] + sure["partly"] + sure["unclear"] if meta["sure"] else 0,
    }  # fmt: skip


def _chosen(cells: Sequence[Cell], meta: Mapping[str, Any]) -> dict[str, int]:
    """Students by option, in the words of the question."""
    found: Counter[str] = Counter()
    for cell in cells:
        for option in cell["chosen"].split(BETWEEN):
            found[option] += cell["n"]
    return {choice["option"]: found[safe_text(choice["option"])] for choice in meta["choices"]}


def _marks(cells: Sequence[Cell]) -> ItemMarks:
    rows = [(cell["n"], cell["marks"] or 0, cell["total"]) for cell in cells]
    return ItemMarks(
        sum(n for n, _, _ in rows),
        sum(n * m for n, m, _ in rows), sum(n * m * m for n, m, _ in rows),
        sum(n * t for n, _, t in rows), sum(n * t * t for n, _, t in rows),
        sum(n * m * t for n, m, t in rows),
    )  # fmt: skip


def _levels(cells: Sequence[Cell]) -> dict[Exact, tuple[int, Exact]]:
    levels: dict[Exact, tuple[int, Exact]] = {}
    for cell in cells:
        n, marks = levels.get(cell["total"], (0, 0))
        levels[cell["total"]] = n + cell["n"], marks + cell["n"] * (cell["marks"] or 0)
    return levels
