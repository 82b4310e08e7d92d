"""Sums from the marks of students, one row for each student and form."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence

from sim.classroom.statistics.item_numbers import ItemMarks
from sim.classroom.statistics.spread import Exact
from sim.classroom.summary.sums import ItemSums


def item_sums(
    counts: Mapping[str, int],
    marks: Sequence[Exact],
    totals: Sequence[Exact],
    chosen: Sequence[str] = (),
    sure: Mapping[str, int] | None = None,
) -> ItemSums:
    """One item in one group. `chosen`: the option of each student, empty where there is none."""
    levels: dict[Exact, tuple[int, Exact]] = {}
    options: dict[str, Counter[Exact]] = {}
    for mark, total in zip(marks, totals, strict=True):
        n, whole = levels.get(total, (0, 0))
        levels[total] = n + 1, whole + mark
    for option, total in zip(chosen, totals, strict=False):
        if option:
            options.setdefault(option, Counter())[total] += 1
    return ItemSums(
        counts=counts,
        chosen={name: sum(found.values()) for name, found in options.items()},
        sure=sure or {},
        marks=ItemMarks(
            len(marks), sum(marks), sum(m * m for m in marks), sum(totals),
            sum(t * t for t in totals), sum(m * t for m, t in zip(marks, totals, strict=True)),
        ),
        levels=levels,
        options=options,
    )  # fmt: skip
