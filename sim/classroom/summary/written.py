"""A summary as a file: `{"format": 1, "kind": "newtons-carts-summary", groups, lessons, …}`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from typing import Any

from sim.classroom.refusal import FEWEST
from sim.classroom.statistics.pair_sums import PairSums
from sim.classroom.statistics.spread import Exact
from sim.classroom.summary.handed_on import Summary
from sim.classroom.summary.numbers import written
from sim.classroom.summary.sums import FormSums, GroupSums, ItemSums, LessonSums

FORMAT = 1
KIND = "newtons-carts-summary"
PAIR_NUMBERS = tuple(f.name for f in fields(PairSums) if f.name != "differences")
MARKS = ("n", "m", "mm", "t", "tt", "mt")


def summary_file(summary: Summary) -> dict[str, Any]:
    """Plain values, to be written as JSON. Lists and keys are in an order of their own."""
    return {
        "format": FORMAT,
        "kind": KIND,
        "fewest": FEWEST,
        "groups": list(summary.groups),
        "withheld": summary.withheld,
        "lessons": [_lesson(lesson) for lesson in summary.lessons],
    }


def _lesson(lesson: LessonSums) -> dict[str, Any]:
    clusters = [_pairs(cluster) for cluster in lesson.clusters]
    return {
        "site": lesson.site, "lesson": lesson.lesson, "table": lesson.table,
        **({"holds": list(lesson.holds)} if lesson.holds else {}),
        "classes": dict(lesson.classes),
        "pairs_of": None if lesson.pairs_of is None else written(lesson.pairs_of),
        "same_items": lesson.same_items, "pairs": _pairs(lesson.pairs),
        "clusters": sorted(clusters, key=repr),  # not in the order of the classes' names
        "forms": [_form(form) for form in lesson.forms.values()],
    }  # fmt: skip


def _pairs(pairs: Mapping[str, PairSums]) -> dict[str, Any]:
    return {
        group: {
            **{name: written(getattr(sums, name)) for name in PAIR_NUMBERS},
            "differences": _histogram(sums.differences),
        }
        for group, sums in pairs.items()
    }


def _histogram(found: Mapping[Exact, int]) -> dict[str, int]:
    return {str(written(value)): found[value] for value in sorted(found)}


def _form(form: FormSums) -> dict[str, Any]:
    return {
        "form": form.form, "has_key": form.has_key,
        "of": None if form.of is None else written(form.of),
        "counted": list(form.counted), "unread": list(form.unread),
        "items": [{**meta, "worth": written(meta["worth"])} for meta in form.items],
        "groups": {group: _group(sums) for group, sums in form.groups.items()},
    }  # fmt: skip


def _group(group: GroupSums) -> dict[str, Any]:
    return {
        "listed": group.listed,
        "totals": _histogram(group.totals),
        **(
            {}
            if group.parts is None
            else {
                "parts": {name: [written(m), written(mm)] for name, (m, mm) in group.parts.items()}
            }
        ),
        "items": {name: _item(item) for name, item in group.items.items()},
    }


def _item(item: ItemSums) -> dict[str, Any]:
    levels = item.levels
    return {
        "counts": dict(item.counts),
        "chosen": dict(sorted(item.chosen.items())),
        "sure": dict(sorted(item.sure.items())),
        "marks": [written(getattr(item.marks, name)) for name in MARKS],
        "levels": None if levels is None else {
            str(written(t)): [levels[t][0], written(levels[t][1])] for t in sorted(levels)
        },
        "options": None if item.options is None else {
            option: _histogram(found) for option, found in sorted(item.options.items())
        },
    }  # fmt: skip
