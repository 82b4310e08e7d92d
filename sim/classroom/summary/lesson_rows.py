"""The report of lessons from their sums: gains, comparisons, and what classes allow to conclude."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from itertools import combinations
from typing import Any

from sim.classroom.refusal import FEWEST, RefusalError
from sim.classroom.report import sentences_of_two as say
from sim.classroom.report.gain_report import (
    comparison_row,
    gain_row,
    only_after_table,
    why_not,
)
from sim.classroom.report.marked import lesson_title
from sim.classroom.statistics.clusters import FEWEST_CLASSES, clustered
from sim.classroom.statistics.pair_sums import NOBODY
from sim.classroom.summary.form_rows import form_row, plain, spread_of_totals
from sim.classroom.summary.sums import LessonSums
from sim.scene.said import said

MOST_GROUPS = 5
"""Groups that are compared two by two; with more, one pair would always look significant."""


@dataclass(frozen=True, slots=True)
class Who:
    """Whose marks they are, where that is known: rows of students, and lists of a gain."""

    students: Mapping[str, list[dict[str, Any]]] = field(default_factory=dict)
    lists: Mapping[str, Mapping[str, list[Any]]] = field(default_factory=dict)


NOBODYS = Who()
NO_LISTS: Mapping[str, list[Any]] = {
    name: [] for name in ("students", "before", "after", "without_before", "without_after")
}


def lesson_row(
    lesson: LessonSums, groups: Sequence[str], who: Who = NOBODYS, *, inference: bool
) -> dict[str, Any]:
    """One lesson of a report."""
    found = [group for group in groups if group in lesson.pairs]
    two = list(combinations(found, 2)) if len(found) <= MOST_GROUPS else []
    compared = [_comparison(lesson, one, other, inference=inference) for one, other in two]
    return {
        "site": lesson.site,
        "lesson": lesson.lesson,
        "title": lesson_title(lesson.lesson, ()),
        "forms": [
            form_row(form, groups, who.students.get(form.form, []), inference=inference)
            for form in lesson.forms.values()
        ],
        "gains": [
            gain_row(
                group, lesson.pairs[group], plain(lesson.pairs_of), same_items=lesson.same_items,
                inference=inference, lists=who.lists.get(group, NO_LISTS),
            )
            for group in found
            if lesson.pairs[group].n
        ],
        "topics": [],
        "topic_differences": [],
        "comparison": compared[0] if len(groups) == 2 and compared else None,
        "comparisons": compared if len(groups) > 2 else [],
        "later": _later(lesson, groups, inference=inference),
    }  # fmt: skip


def _comparison(lesson: LessonSums, one: str, other: str, *, inference: bool) -> dict[str, Any]:
    names = (one, other)
    classes = _classes(lesson, names)
    halves = [
        (cluster.get(one), cluster.get(other))
        for cluster in lesson.clusters
        if one in cluster or other in cluster
    ]
    whole = sum((pair.n for pairs in halves for pair in pairs if pair), 0)
    complete = whole == lesson.pairs.get(one, NOBODY).n + lesson.pairs.get(other, NOBODY).n
    robust = bool(halves) and complete and len(halves) >= FEWEST_CLASSES and min(classes) > 1
    says = say.ONE_CLASS if min(classes) < 2 else ""
    if lesson.table:
        says = say.of_classes(classes, names, robust=robust) if halves else say.WHO_KNOWS
    row = comparison_row(
        names, lesson.pairs[one], lesson.pairs[other], with_p=min(classes) > 1,
        inference=inference, says=says,
    )  # fmt: skip
    row["clustered"] = None
    if robust and inference and min(row["n"]) >= FEWEST:
        try:
            test = clustered(halves)
        except RefusalError as refused:
            row["refusals"].append(why_not("clustered", refused))
        else:
            row["clustered"] = {"classes": len(halves), **asdict(test)}
            what = said("Counted by classes, {n} of them", n=f"{len(halves)}")
            row["sentences"].append(say.of_difference(what, test, names, with_p=True))
    return row


def _classes(lesson: LessonSums, names: tuple[str, str]) -> tuple[int, int]:
    one, other = (lesson.classes.get(name, 1) for name in names)
    return one, other


def _later(lesson: LessonSums, groups: Sequence[str], *, inference: bool) -> list[dict[str, Any]]:
    """Two groups on forms that have no pair."""
    if len(groups) != 2 or not inference:
        return []
    paired = ("pre", "post") if {"pre", "post"} <= lesson.forms.keys() else ()
    names = (groups[0], groups[1])
    rows = []
    for form in lesson.forms.values():
        if form.form in ("worksheet", *paired) or form.of == 0:
            continue
        totals = [form.groups[name].totals for name in names if name in form.groups]
        if len(totals) == 2 and all(totals):
            spreads = [spread_of_totals(hist) for hist in totals]
            classes = min(_classes(lesson, names))
            rows.append(only_after_table(form.form, spreads, names, classes=classes))
    return rows
