"""What of a school's sums may be handed on: nothing about a single student.

Groups of fewer than five students are withheld, in a form, among those who took both tests, and in
a class. Not handed on either, unless asked for: the marks of students by their total. Where one
student alone has a total, they are that student's answers. Options that are longer than a letter
and are no right answer may have been typed, so they are counted as “other”.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from sim.classroom.refusal import FEWEST
from sim.classroom.statistics.pair_sums import PairSums
from sim.classroom.summary.sums import FormSums, GroupSums, ItemSums, LessonSums, all_added

OTHER = "other"


@dataclass(frozen=True, slots=True)
class Summary:
    """Sums that may leave a school. `withheld`: how many groups were too small. Of students with
    both tests who are in no pair: how many are of classes too small, and how many of none.
    """

    groups: tuple[str, ...]
    lessons: tuple[LessonSums, ...]
    withheld: int
    of_small_classes: int = 0
    of_no_class: int = 0


def handed_on(
    lessons: Iterable[LessonSums], groups: Iterable[str], *, by_total: bool = False
) -> Summary:
    """The summary; `by_total`: with the marks by total, which discrimination and curves need."""
    lessons, kept, withheld = list(lessons), [], 0
    for lesson in lessons:
        made, count = _lesson(lesson, by_total=by_total)
        withheld += count
        if made.forms:
            kept.append(made)
    named = {group for lesson in kept for form in lesson.forms.values() for group in form.groups}
    small = sum(map(_of_small_classes, lessons))
    none = sum(map(_of_no_class, lessons))
    return Summary(tuple(g for g in groups if g in named), tuple(kept), withheld, small, none)


def _of_small_classes(lesson: LessonSums) -> int:
    pairs = (sums for cluster in lesson.clusters for sums in cluster.values())
    return sum(sums.n for sums in pairs if sums.n < FEWEST)


def _of_no_class(lesson: LessonSums) -> int:
    """Students whose class nobody told, where that of others is. Their pairs would not fit into the
    sums by classes, and those of classes too small could be taken from them."""
    if not lesson.clusters:
        return 0
    known = sum(sums.n for cluster in lesson.clusters for sums in cluster.values())
    return sum(sums.n for sums in lesson.pairs.values()) - known


def _lesson(lesson: LessonSums, *, by_total: bool) -> tuple[LessonSums, int]:
    forms: dict[str, FormSums] = {}
    withheld = 0
    for name, form in lesson.forms.items():
        groups = {
            group: _group(sums, form, typed=lesson.table, by_total=by_total)
            for group, sums in form.groups.items()
            if sums.n >= FEWEST
        }
        withheld += sum(sums.listed > 0 and g not in groups for g, sums in form.groups.items())
        if groups:
            items = tuple(_meta(meta) for meta in form.items) if lesson.table else form.items
            forms[name] = replace(form, groups=groups, items=items)
    clusters = tuple(kept for cluster in lesson.clusters if (kept := _enough(cluster)))
    pairs = all_added(clusters) if lesson.clusters else _enough(lesson.pairs)
    withheld += sum(s.n > 0 and g not in pairs for g, s in lesson.pairs.items())
    classes = {
        g: n for g, n in lesson.classes.items() if any(g in f.groups for f in forms.values())
    }
    made = replace(lesson, forms=forms, pairs=pairs, clusters=clusters, classes=classes)
    return made, withheld


def _enough(pairs: Mapping[str, PairSums]) -> dict[str, PairSums]:
    return {group: sums for group, sums in pairs.items() if sums.n >= FEWEST}


def _group(sums: GroupSums, form: FormSums, *, typed: bool, by_total: bool) -> GroupSums:
    metas = {meta["id"]: meta for meta in form.items}
    items = {
        name: _item(item, metas[name], typed=typed, by_total=by_total)
        for name, item in sums.items.items()
    }
    return replace(sums, items=items)


def _item(item: ItemSums, meta: Mapping[str, Any], *, typed: bool, by_total: bool) -> ItemSums:
    if not by_total:
        item = replace(item, levels=None, options=None)
    if not typed:
        return item
    names = {choice["option"]: _option(choice) for choice in meta["choices"]}
    chosen: Counter[str] = Counter()
    for option, count in item.chosen.items():
        chosen[names[option]] += count
    if item.options is None:
        return replace(item, chosen=chosen)
    options = all_added({names[o]: Counter(found)} for o, found in item.options.items())
    return replace(item, chosen=chosen, options=options)


def _option(choice: Mapping[str, Any]) -> str:
    option = str(choice["option"])
    return option if len(option) == 1 or choice["correct"] else OTHER


def _meta(meta: Mapping[str, Any]) -> dict[str, Any]:
    choices = {_option(choice): choice for choice in meta["choices"]}
    return {**meta, "choices": [
        {**choice, "option": option, "label": OTHER if option == OTHER else choice["label"]}
        for option, choice in choices.items()
    ]}  # fmt: skip
