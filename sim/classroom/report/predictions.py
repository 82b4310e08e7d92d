"""What a class predicted before it saw a run: choices, arrows, curves and words, with the reasons.

A prediction has no key: nothing here is right or wrong. Equal ones are counted together, so that a
teacher sees what the class expected; curves are handed on as they were drawn, to lie over each
other. What was said again by a student who had seen the run is no prediction: it is counted apart.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

from sim.classroom.report.marked import Marked
from sim.classroom.report.most_said import most_said
from sim.classroom.report.prediction_meaning import predictions_in_words
from sim.lesson.answer_file import PREDICTIONS, Item
from sim.lesson.mark import is_empty


def prediction_rows(files: Sequence[Marked]) -> list[dict[str, Any]]:
    """One row for each scene that asked first, in the order in which they were met."""
    found: dict[str, list[tuple[Marked, Item]]] = {}
    for file in files:
        for name, item in file.file.latest().items():
            if item.type in PREDICTIONS and not is_empty(item.value):
                found.setdefault(name, []).append((file, item))
    rows = [_row(name, made) for name, made in found.items()]
    return sorted(rows, key=lambda row: row.pop("first"))


def _row(name: str, made: Sequence[tuple[Marked, Item]]) -> dict[str, Any]:
    first = made[0][1]
    each = predictions_in_words([item for _, item in made])
    before = [
        (item, words)
        for (_, item), words in zip(made, each, strict=True)
        if "again" not in item.more
    ]
    items = [item for item, _ in before]
    drawn = first.type == "curve"  # in words each one is different
    words, more = most_said(() if drawn else (words for _, words in before))
    sure = Counter(words for item, words in before if item.more.get("sure") == "sure")
    curves = [[float(h) for h in item.value] for item in items if _is_curve(item)]
    return {
        "id": name,
        "type": first.type,
        "ask": next((item.more["asked"] for _, item in made if item.more.get("asked")), ""),
        "n": len(items),
        "again": len(made) - len(items),
        "asked_sure": any(item.more.get("sure") for item in items),
        "locked": sum("locked" in item.more for item in items),
        "answers": [{"said": said, "count": count, "sure": sure[said]} for said, count in words],
        "more": more,
        "curves": curves,
        "reasons": [
            {"student": file.who, "said": words, "why": item.more["why"]}
            for (file, item), words in zip(made, each, strict=True)
            if item.more.get("why")
        ],
        "first": min(item.first or "" for _, item in made),
    }


def _is_curve(item: Item) -> bool:
    value = item.value
    return (
        item.type == "curve"
        and isinstance(value, list)
        and len(value) > 1
        and all(isinstance(h, (int, float)) and not isinstance(h, bool) for h in value)
    )
