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
from sim.classroom.statistics.spread import spread

FEWEST_ITEMS = 3
"""Questions of a topic; with fewer a single one would decide."""


def topic_rows(
    by_form: Mapping[str, Sequence[Marked]], key: KeyedForm | None, groups: Sequence[str]
) -> list[dict[str, Any]]:
    """One row for each topic and group with enough questions and pairs."""
    if key is None or "pre" not in by_form or "post" not in by_form:
        return []
    topics: dict[str, list[str]] = {}
    for name, item in key.items.items():
        for topic in item.question.common.topics:
            topics.setdefault(topic, []).append(name)
    rows = []
    for topic, items in topics.items():
        if not FEWEST_ITEMS <= len(items) < len(key.items):
            continue
        for group in groups:
            pairs = pair_up(by_form["pre"], by_form["post"], group, items)
            if pairs is None or not pairs.same_items or len(pairs.students) < FEWEST:
                continue
            before, after = spread(pairs.before), spread(pairs.after)
            rows.append({
                "topic": topic, "questions": len(items), "group": group, "n": before.n,
                "of": pairs.of, "pre": asdict(before), "post": asdict(after),
                "gain": _gain(before.mean, after.mean, pairs.of),
            })  # fmt: skip
    return rows


def _gain(before: float, after: float, of: float) -> float | None:
    try:
        return hake_gain(before, after, of)
    except RefusalError:
        return None
