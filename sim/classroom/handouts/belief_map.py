"""The misconception map of a class: which belief stands behind which answers, and how often.

Rows are beliefs, columns the questions with an answer that goes with one; each cell counts the
students who chose such an answer. One answer is no diagnosis: a row with numbers in several columns
says more than a large number in one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class BeliefMap:
    """`questions`: numbers of the columns. `rows`: what students often think, and a count for each
    question; None where no answer of it goes with the belief."""

    questions: tuple[int, ...]
    rows: tuple[tuple[str, tuple[int | None, ...]], ...]


def belief_map(items: Sequence[tuple[int, Mapping[str, Any]]]) -> BeliefMap:
    """The map of a form's items with their numbers; most chosen beliefs first."""
    counts: dict[str, dict[int, int]] = {}
    for number, item in items:
        for choice in item["choices"]:
            if says := choice.get("says", ""):
                row = counts.setdefault(says, {})
                row[number] = row.get(number, 0) + int(choice["count"])
    chosen = {says: row for says, row in counts.items() if any(row.values())}
    asked = [number for number, _ in items if any(row.get(number) for row in chosen.values())]
    rows = sorted(chosen.items(), key=lambda one: (-sum(one[1].values()), one[0]))
    return BeliefMap(
        tuple(asked),
        tuple((says, tuple(map(row.get, asked))) for says, row in rows),
    )
