"""What a prediction means, in whatever language it was made.

An answer keeps its words as its page said them. A class may read in several languages, and its
report in another one: options of a choice are counted by their place, and which of two arrows is
longer is told anew from their lengths. What a student wrote stays as it was written.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Sequence
from itertools import groupby
from typing import Any

from sim.lesson.answer_file import Item
from sim.scene.said import joined, said

SEPARATOR = " · "
"""What stands in an answer's words between the prediction and what was said besides."""

ALIKE = 0.06
"""Of the longer arrow: nearer than this two were meant to be equal, as in the page."""

WALLS = ("left", "right")


def predictions_in_words(items: Sequence[Item]) -> list[str]:
    """Each prediction in words: equal ones in the same, those that most of them have."""
    by_meaning: dict[Hashable, Counter[str]] = {}
    for item in items:
        by_meaning.setdefault(_meaning(item), Counter())[words_of(item)] += 1
    words = {meaning: counts.most_common(1)[0][0] for meaning, counts in by_meaning.items()}
    return [words[_meaning(item)] for item in items]


def words_of(item: Item) -> str:
    """The prediction in words; without them its value."""
    if relations := _relations(item):
        return joined(*relations)
    kept = item.more.get("said", "").split(SEPARATOR)[0].strip()
    return kept or str(item.value)


def _meaning(item: Item) -> Hashable:
    """Equal for predictions that say the same."""
    if item.type == "choice" and isinstance(item.value, str):
        return item.value, "option"
    return words_of(item)


def _relations(item: Item) -> list[str]:
    """Which arrow of each contact is longer; empty where it cannot be told from the value alone."""
    rows = item.value if item.type == "arrows" else None
    if not isinstance(rows, list) or not all(map(_is_arrow, rows)):
        return []
    pairs = [list(made) for _, made in groupby(rows, key=lambda row: row["pair"])]
    if not all(len(pair) == 2 for pair in pairs):
        return []
    return [_relation(*pair) for pair in pairs]


def _is_arrow(row: Any) -> bool:
    if not isinstance(row, dict) or not all(isinstance(row.get(k), str) for k in ("pair", "on")):
        return False
    share = row.get("share")
    number = isinstance(share, (int, float)) and not isinstance(share, bool)
    return number and row["on"] not in WALLS


def _relation(one: dict[str, Any], other: dict[str, Any]) -> str:
    small, large = sorted((one, other), key=lambda row: float(row["share"]))
    most = large["share"]
    if not most:
        return said("no force on either.")
    if most - small["share"] <= ALIKE * most:
        return said("both forces are equally large.")
    longer = said("force on {on} by {by}", on=large["on"], by=small["on"])
    if not small["share"]:
        return said("only the {force}.", force=longer)
    shorter = said("force on {on} by {by}", on=small["on"], by=large["on"])
    return said("the {large} is larger than the {small}.", large=longer, small=shorter)
