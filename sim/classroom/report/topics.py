"""Before and after, topic by topic: the first law beside the third, as the paper did it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from sim.classroom.files.keyed import KeyedForm
from sim.classroom.refusal import FEWEST, RefusalError
from sim.classroom.report.marked import Marked
from sim.classroom.report.pairing import pair_up
from sim.classroom.statistics.gain import hake_gain
from sim.classroom.statistics.spread import Spread, spread

FEWEST_ITEMS = 3
"""Questions of a topic; with fewer a single one would decide."""


def topic_rows(
    by_form: Mapping[str, Sequence[Marked]], key: KeyedForm | None, groups: Sequence[str]
) -> list[dict[str, Any]]:
    """One row for each topic and group with enough questions and pairs."""
    if key is None or "pre" not in by_form or "post" not in by_form:
        return []
    rows = []
    for topic, items in topics_of(key).items():
        for group in groups:
            pairs = pair_up(by_form["pre"], by_form["post"], group, items)
            if pairs is None or not pairs.same_items or len(pairs.students) < FEWEST:
                continue
            before, after = spread(pairs.before), spread(pairs.after)
            rows.append(topic_row(topic, len(items), group, before, after, pairs.of))
    return rows


def topics_of(key: KeyedForm) -> dict[str, list[str]]:
    """The topics of a form that are worth a row, each with its questions."""
    topics: dict[str, list[str]] = {}
    for name, item in key.items.items():
        for topic in item.question.common.topics:
            topics.setdefault(topic, []).append(name)
    return {
        topic: items
        for topic, items in topics.items()
        if FEWEST_ITEMS <= len(items) < len(key.items)
    }


def topic_row(
    topic: str, questions: int, group: str, before: Spread, after: Spread, of: float
) -> dict[str, Any]:
    """One topic in one group; `of`: the marks of its questions."""
    return {
        "topic": topic, "questions": questions, "group": group, "n": before.n,
        "of": of, "pre": asdict(before), "post": asdict(after),
        "gain": _gain(before.mean, after.mean, of),
    }  # fmt: skip


def _gain(before: float, after: float, of: float) -> float | None:
    try:
        return hake_gain(before, after, of)
    except RefusalError:
        return None
