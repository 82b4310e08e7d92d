"""What to talk about first: where many chose one wrong answer, and above all where they were sure.

A wrong answer that a student is sure of is a belief; one that is guessed is a gap. So sure wrong
answers count twice. The order is a suggestion for the next lesson, no statistic.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sim.classroom.report.sentences import begins
from sim.scene.said import said

FEWEST = 2
"""Students who chose the same wrong answer, before it is worth a talk in class."""

MOST = 3

LONGEST = 80
"""Characters of an option that are said: enough to know it again."""


def talk_rows(items: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """At most three questions of a form, the most urgent first."""
    found = []
    for item in items:
        wrong = [c for c in item["choices"] if not c.get("correct", False) and item["worth"]]
        most = max(wrong, key=_weight, default=None)
        if most is None or most["count"] < FEWEST:
            continue
        found.append((_weight(most), {"id": item["id"], "sentence": _sentence(item, most)}))
    found.sort(key=lambda one: -one[0])
    return [row for _, row in found[:MOST]]


def _sentence(item: dict[str, Any], most: dict[str, Any]) -> str:
    """How many chose what, how sure they were, and what they may think."""
    text = said("{question}: {count} of {answered} chose {answer}", question=item["label"],
                count=f"{most['count']}", answered=f"{item['answered']}",
                answer=_answer(most))  # fmt: skip
    if most.get("sure"):
        text = said("{sentence}, {count} of them sure", sentence=text, count=f"{most['sure']}")
    if most.get("says"):
        return said("{sentence}; students who choose it often think: “{belief}”", sentence=text,
                    belief=most["says"])  # fmt: skip
    return said("{sentence}.", sentence=text)


def _answer(choice: dict[str, Any]) -> str:
    """The letter of an option and how its text begins; a number as it was typed."""
    words = choice["text"]
    if not words:
        return str(choice["label"])
    return said("{letter} (“{text}”)", letter=choice["label"], text=begins(words, LONGEST))


def _weight(choice: dict[str, Any]) -> int:
    return int(choice["count"]) + int(choice.get("sure") or 0)
