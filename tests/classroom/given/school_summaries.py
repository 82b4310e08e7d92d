"""Schools made up for tests, and the sums that leave them through a file."""

from __future__ import annotations

import json
import random
from collections.abc import Sequence
from typing import Any

from sim.classroom.summary.handed_on import Summary, handed_on
from sim.classroom.summary.reading import read_summary
from sim.classroom.summary.written import summary_file
from tests.classroom.given.tables import csv, judged

ITEMS = ("Q1", "Q2", "Q3")
HEAD = ("student", "group", "class", *(f"{form}_{i}" for form in ("pre", "post") for i in ITEMS))
MOST = ["MAX", "", "", 1, 1, 2, 1, 1, 2]


def school(number: int, dice: random.Random, counts: Sequence[int]) -> list[list[object]]:
    """Students of two groups, a class each, with decimal marks; nobody is there twice."""
    return [
        [f"{number}-{group}-{k}", group, f"{number}{group}",
         *(dice.choice(["0", "0.1", "0.7", "1"]) for _ in range(6))]
        for group, count in zip("ab", counts, strict=True)
        for k in range(count)
    ]  # fmt: skip


def through_a_file(summary: Summary) -> Summary:
    """What is left after writing and reading."""
    return read_summary(json.dumps(summary_file(summary)).encode())


def of_table(rows: Sequence[Sequence[object]], *, by_total: bool = True) -> Summary:
    found = judged(csv(HEAD, [MOST, *rows]))
    return through_a_file(handed_on([found.lesson], found.groups, by_total=by_total))


def bits(report: dict[str, Any]) -> str:
    """Every number of a report; JSON writes floats so that no bit is lost."""
    return json.dumps(report, allow_nan=False)
