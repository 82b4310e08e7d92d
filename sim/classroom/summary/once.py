"""No student counts twice: the same summary again, and a sum beside what it was made of.

Every lesson of a summary has a fingerprint of its sums, and a sum holds those of all that it was
added from. Marks by total are in no fingerprint: with them and without it is the same class.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from hashlib import sha256
from typing import Any

from sim.classroom.summary.handed_on import Summary
from sim.classroom.summary.sums import LessonSums
from sim.scene.said import said

Named = tuple[str, Summary]
Place = tuple[str, str]
Found = tuple[int, str, LessonSums]
"""The number of a summary, its name, and a lesson in it."""

DIGITS = 16


def fingerprint(row: Mapping[str, Any]) -> str:
    """Of the sums of a lesson as a summary writes them."""
    forms = sorted(
        ([form["form"], group, sums["listed"], sums["totals"],
          {name: item["marks"] for name, item in sums["items"].items()}]
         for form in row["forms"] for group, sums in form["groups"].items()),
        key=lambda one: one[:2],
    )  # fmt: skip
    text = json.dumps([row["site"], row["lesson"], row["pairs"], forms], sort_keys=True)
    return sha256(text.encode()).hexdigest()[:DIGITS]


def once(summaries: Sequence[Named]) -> tuple[list[Named], list[tuple[str, str]], list[str]]:
    """The summaries without lessons that others hold already; what was left out, name and reason;
    and what has to be said of sums that stand beside other summaries."""
    places: dict[Place, list[Found]] = {}
    for number, (name, summary) in enumerate(summaries):
        for lesson in summary.lessons:
            places.setdefault((lesson.site, lesson.lesson), []).append((number, name, lesson))
    kept: dict[int, list[LessonSums]] = {}
    left_out: list[tuple[str, str]] = []
    notes: dict[str, str] = {}
    for found in places.values():
        counts, doubled = _disjoint(found)
        left_out += doubled
        for number, name, lesson in counts:
            kept.setdefault(number, []).append(lesson)
            if len(counts) > 1 and len(lesson.holds) > 1:
                notes[name] = _sum_beside(name, len(lesson.holds))
    made = [
        (name, replace(summary, lessons=tuple(kept.get(number, ()))))
        for number, (name, summary) in enumerate(summaries)
        if number in kept or not summary.lessons
    ]
    return made, left_out, list(notes.values())


def _disjoint(found: Sequence[Found]) -> tuple[list[Found], list[tuple[str, str]]]:
    """Those of one lesson that have nothing in common; sums of many come before their parts."""
    counts: list[Found] = []
    left_out = []
    holder: dict[str, Found] = {}
    for one in sorted(found, key=lambda one: -len(one[2].holds)):
        _, name, lesson = one
        other = next((holder[mine] for mine in lesson.holds if mine in holder), None)
        if other is None:
            counts.append(one)
            holder |= dict.fromkeys(lesson.holds, one)
        else:
            left_out.append((name, _why(lesson, other[1], {*other[2].holds})))
    return counts, left_out


def _why(lesson: LessonSums, other: str, holds: set[str]) -> str:
    mine = {*lesson.holds}
    if mine == holds:
        return said("{lesson}: the same sums as in {other}; they count once",
                    lesson=lesson.lesson, other=other)  # fmt: skip
    if mine < holds:
        return said("{lesson}: {other} is a sum that holds it; it counts once",
                    lesson=lesson.lesson, other=other)  # fmt: skip
    return said("{lesson}: {other} holds some of the same schools; not counted",
                lesson=lesson.lesson, other=other)  # fmt: skip


def _sum_beside(name: str, n: int) -> str:
    return said(
        "{name} is a sum of {n} summaries. If one of them was made anew since and stands beside "
        "it, its students count twice.",
        name=name, n=f"{n}",
    )  # fmt: skip
