"""Exact sums of a lesson: of two schools they add, in any order, to those of both.

Nothing is rounded before the report: marks are whole numbers or fractions. So a report made from
added sums has the same bits as one made from all answers at once.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, TypeVar

from sim.classroom.statistics.item_numbers import ItemMarks, Levels
from sim.classroom.statistics.pair_sums import PairSums
from sim.classroom.statistics.spread import Exact

COUNTS = ("n", "answered", "right", "partly", "wrong", "empty", "unread", "sure_right",
          "sure_wrong")  # fmt: skip
FORMS = ("pre", "worksheet", "post", "delayed", "test")
"""In the order of a report; `test` is a table's only one."""

K = TypeVar("K")


def added(one: Mapping[K, Any], other: Mapping[K, Any]) -> dict[K, Any]:
    """Two maps, values under one key added; keys in the order of the first, then of the other."""
    total = dict(one)
    for key, value in other.items():
        total[key] = total[key] + value if key in total else value
    return total


def all_added(maps: Iterable[Mapping[K, Any]]) -> dict[K, Any]:
    """Many maps, one after the other."""
    total: dict[K, Any] = {}
    for one in maps:
        total = added(total, one)
    return total


@dataclass(frozen=True, slots=True, kw_only=True)
class ItemSums:
    """One item in one group. `chosen` and `sure`: students by option. `marks`: sums with totals.

    `levels`: by the total that students have; `options`: option → total → students. Both are None
    where they were not handed on: with few students they would show the answers of one.
    """

    counts: Mapping[str, int]
    chosen: Mapping[str, int]
    sure: Mapping[str, int]
    marks: ItemMarks
    levels: Levels | None
    options: Mapping[str, Mapping[Exact, int]] | None

    def choosing(self, chosen: Mapping[str, int], sure: Mapping[str, int]) -> ItemSums:
        """The same with how many chose each option; by which students is not known."""
        return replace(self, chosen=chosen, sure=sure, options=None)

    def __add__(self, other: ItemSums) -> ItemSums:
        a, b = self.marks, other.marks
        return ItemSums(
            counts=added(self.counts, other.counts),
            chosen=added(self.chosen, other.chosen),
            sure=added(self.sure, other.sure),
            marks=ItemMarks(a.n + b.n, a.m + b.m, a.mm + b.mm, a.t + b.t, a.tt + b.tt, a.mt + b.mt),
            levels=_levels(self.levels, other.levels),
            options=_options(self.options, other.options),
        )


def _levels(one: Levels | None, other: Levels | None) -> Levels | None:
    if one is None or other is None:
        return None
    total = dict(one)
    for level, (count, marks) in other.items():
        n, m = total.get(level, (0, 0))
        total[level] = n + count, m + marks
    return total


def _options(
    one: Mapping[str, Mapping[Exact, int]] | None, other: Mapping[str, Mapping[Exact, int]] | None
) -> Mapping[str, Mapping[Exact, int]] | None:
    if one is None or other is None:
        return None
    names = dict.fromkeys([*one, *other])
    return {name: added(one.get(name, {}), other.get(name, {})) for name in names}


@dataclass(frozen=True, slots=True, kw_only=True)
class GroupSums:
    """One group in one form: `listed` students, of whom those in `totals` are counted.

    `parts`: Σm and Σm² of each item, of counted students alone; None where all are counted.
    """

    listed: int
    totals: Mapping[Exact, int]
    items: Mapping[str, ItemSums]
    parts: Mapping[str, tuple[Exact, Exact]] | None = None

    @property
    def n(self) -> int:
        """Students who are counted."""
        return sum(self.totals.values())

    def part(self, name: str) -> tuple[Exact, Exact]:
        """Σm and Σm² of an item, of counted students."""
        if self.parts is not None:
            return self.parts.get(name, (0, 0))
        item = self.items.get(name)
        return (item.marks.m, item.marks.mm) if item else (0, 0)

    def __add__(self, other: GroupSums) -> GroupSums:
        parts = None
        if self.parts is not None or other.parts is not None:
            pairs = {name: (self.part(name), other.part(name)) for name in self.items}
            parts = {name: (a[0] + b[0], a[1] + b[1]) for name, (a, b) in pairs.items()}
        return GroupSums(
            listed=self.listed + other.listed,
            totals=Counter(self.totals) + Counter(other.totals),
            items=added(self.items, other.items),
            parts=parts,
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class FormSums:
    """One form. `of`: marks of the `counted` items together, None where nobody knows.

    `items`: what is asked, as in the rows of a report: id, label, ask, type, worth, choices.
    """

    form: str
    has_key: bool
    of: Exact | None
    counted: tuple[str, ...]
    unread: tuple[str, ...]
    items: tuple[Mapping[str, Any], ...]
    groups: Mapping[str, GroupSums]


Cluster = Mapping[str, PairSums]
"""One class: its students who took both tests, by group."""


@dataclass(frozen=True, slots=True, kw_only=True)
class LessonSums:
    """A lesson. `pairs`: by group; `clusters`: the same class by class, where classes are known.

    `classes`: how many classes a group holds; `pairs_of`: marks of both tests of the pairs.
    `table`: it tells itself which classes there are. `holds`: fingerprints of the summaries that it
    was added from, or its own.
    """

    site: str
    lesson: str
    forms: Mapping[str, FormSums]
    pairs: Mapping[str, PairSums] = field(default_factory=dict)
    pairs_of: Exact | None = None
    same_items: bool = False
    clusters: tuple[Cluster, ...] = ()
    classes: Mapping[str, int] = field(default_factory=dict)
    table: bool = False
    holds: tuple[str, ...] = ()
