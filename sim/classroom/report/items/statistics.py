"""The numbers of an item and of a whole test in their rows, or why there are none."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

from sim.classroom.refusal import FEWEST, RefusalError, at_least
from sim.classroom.report import sentences as say
from sim.classroom.statistics.item_numbers import (
    QUARTER,
    ItemMarks,
    Levels,
    curve,
    share_of_marks,
    upper_minus_lower,
    with_others,
    with_total,
)
from sim.classroom.statistics.reliability import alpha, delta
from sim.classroom.statistics.spread import Exact
from sim.scene.said import reason_of, said, template

NAMES = {
    "difficulty": template("difficulty"),
    "discrimination": template("discrimination"),
    "point_biserial": template("point-biserial"),
}

NO_NUMBERS: Mapping[str, None] = {
    "point_biserial_total": None,
    "discrimination_quarter": None,
    "curve": None,
}
"""Further numbers of an item, for who compares with published tables; they make no notes."""


def add_numbers(
    row: dict[str, Any],
    sums: ItemMarks,
    levels: Levels | None,
    of: Exact,
    everybody: tuple[int, Exact] | None = None,
) -> None:
    """Adds what the marks say to the row of an item; `levels` None: they were not handed on.

    `everybody`: how many answered and Σm, where some have no total and are in no other sum.
    """
    add_difficulty(row, *(everybody or (sums.n, sums.m)), of)
    _add(row, "discrimination", lambda: upper_minus_lower(_known(levels), of))
    _add(row, "point_biserial", lambda: with_others(sums))
    quiet: dict[str, Callable[[], Any]] = {
        "point_biserial_total": lambda: with_total(sums),
        "discrimination_quarter": lambda: upper_minus_lower(_known(levels), of, QUARTER),
        "curve": lambda: curve(_known(levels), of),
    }
    for name, statistic in quiet.items():
        try:
            row[name] = statistic()
        except RefusalError:
            row[name] = None


def option_curves(
    row: dict[str, Any],
    levels: Levels | None,
    options: Mapping[str, Mapping[Exact, int]] | None,
) -> None:
    """Adds to each answer how much of each quarter of the class chose it, the weakest first."""
    if levels is None or options is None:
        return
    for choice in row["choices"]:
        chose = options.get(choice["option"], {})
        of_option = {total: (n, chose.get(total, 0)) for total, (n, _) in levels.items()}
        try:
            choice["curve"] = curve(of_option, 1)
        except RefusalError:
            choice["curve"] = None


def _known(levels: Levels | None) -> Levels:
    if levels is None:
        raise RefusalError(say.NO_LEVELS)
    return levels


def add_difficulty(row: dict[str, Any], n: int, m: Exact, of: Exact) -> None:
    """Adds the difficulty alone, from Σm of n students, or why there is none."""
    _add(row, "difficulty", lambda: _difficulty(n, m, of))


def _difficulty(n: int, m: Exact, of: Exact) -> float:
    at_least(n, FEWEST)
    return share_of_marks(n, m, of)


def _add(row: dict[str, Any], name: str, statistic: Callable[[], float]) -> None:
    try:
        row[name] = statistic()
    except RefusalError as refused:
        row["notes"].append(said("{name}: {reason}", name=NAMES[name], reason=reason_of(refused)))


def whole_test(
    n: int,
    items: Sequence[tuple[Exact, Exact]],
    totals: Mapping[Exact, int],
    of: Exact | None,
    *,
    by_item: bool = True,
) -> dict[str, Any]:
    """Cronbach's alpha and Ferguson's delta of a form, with sentences or reasons.

    `items`: Σm and Σm² of each question that counts. `totals`: how many students have each.
    `by_item` False: only totals are known.
    """
    row: dict[str, Any] = {"alpha": None, "delta": None, "sentences": []}
    if of == 0:
        return row
    made: dict[str, tuple[Callable[[], float], Callable[[float], str]]] = {
        "alpha": (partial(_alpha, n, items, totals, by_item=by_item), say.of_alpha),
        "delta": (lambda: _delta(n, totals, of), say.of_delta),
    }
    for name, (statistic, sentence) in made.items():
        try:
            row[name] = statistic()
            row["sentences"].append(sentence(row[name]))
        except RefusalError as refused:
            row["sentences"].append(said("{name}: {reason}.", name=name, reason=reason_of(refused)))
    return row


def _alpha(
    n: int, items: Sequence[tuple[Exact, Exact]], totals: Mapping[Exact, int], *, by_item: bool
) -> float:
    if not by_item:
        raise RefusalError(say.NO_ITEMS)
    return alpha(n, items, totals)


def _delta(n: int, totals: Mapping[Exact, int], of: Exact | None) -> float:
    if of is None:
        raise RefusalError(say.NO_MOST)
    return delta(n, totals, of)
