"""What to talk about first: where many chose one wrong answer, and above all where they were sure.

A wrong answer that a student is sure of is a belief; one that is guessed is a gap. So sure wrong
answers count twice. The order is a suggestion for the next lesson, no statistic.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

FEWEST = 2
"""Students who chose the same wrong answer, before it is worth a talk in class."""

MOST = 3


def talk_rows(items: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """At most three questions of a form, the most urgent first."""
    found = []
    for item in items:
        wrong = [c for c in item["choices"] if not c.get("correct", False) and item["worth"]]
        most = max(wrong, key=_weight, default=None)
        if most is None or most["count"] < FEWEST:
            continue
        sure = f", {most['sure']} of them sure" if most.get("sure") else ""
        text = f"{item['label']}: {most['count']} of {item['answered']} chose {most['label']}{sure}"
        if most.get("says"):
            text += f"; students who choose it often think: “{most['says']}”"
        found.append((_weight(most), {"id": item["id"], "sentence": f"{text}."}))
    found.sort(key=lambda one: -one[0])
    return [row for _, row in found[:MOST]]


def _weight(choice: dict[str, Any]) -> int:
    return int(choice["count"]) + int(choice.get("sure") or 0)
