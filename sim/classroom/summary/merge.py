"""Summaries of many schools added: the same in any order, and equal to all answers at once.

Two schools can be added where the same was asked. Of different versions the one that most schools
have is counted, and the others are named.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from sim.classroom.statistics.spread import Exact
from sim.classroom.summary.handed_on import Summary
from sim.classroom.summary.once import Named, Place
from sim.classroom.summary.sums import FORMS, FormSums, LessonSums, all_added
from sim.scene.said import said


def merged(summaries: Sequence[Named]) -> tuple[Summary, list[tuple[str, str]]]:
    """The sum, and what was left out: name and reason."""
    asked = {
        id(form): _asked(form)
        for _, summary in summaries
        for lesson in summary.lessons
        for form in lesson.forms.values()
    }
    usual = _usual(summaries, asked)
    lessons: dict[Place, list[LessonSums]] = {}
    left_out = []
    for name, summary in summaries:
        for lesson in summary.lessons:
            place = (lesson.site, lesson.lesson)
            forms = {}
            for form in lesson.forms.values():
                if usual[(*place, form.form)] == asked[id(form)]:
                    forms[form.form] = form
                else:
                    reason = said(
                        "{lesson}, form {form}: other questions, other marks, or other answers "
                        "still to be read than in most summaries; not counted",
                        lesson=lesson.lesson, form=form.form,
                    )  # fmt: skip
                    left_out.append((name, reason))
            lessons.setdefault(place, []).append(_without(lesson, forms))
    groups = _order([summary.groups for _, summary in summaries])
    made = tuple(_lesson(found, groups) for _, found in sorted(lessons.items()))
    withheld = sum(summary.withheld for _, summary in summaries)
    return Summary(groups, tuple(m for m in made if m.forms), withheld), sorted(left_out)


def _without(lesson: LessonSums, forms: Mapping[str, FormSums]) -> LessonSums:
    """Pairs count where both of their forms do, and a lesson is in the sum with any form."""
    whole = {"pre", "post"} <= forms.keys()
    return replace(
        lesson,
        forms=forms,
        pairs=lesson.pairs if whole else {},
        clusters=lesson.clusters if whole else (),
        holds=lesson.holds if forms else (),
    )


def _usual(
    summaries: Sequence[Named], asked_in: Mapping[int, str]
) -> dict[tuple[str, str, str], str]:
    """What most summaries ask in each form; of equally many the first by its text."""
    found: dict[tuple[str, str, str], Counter[str]] = {}
    for _, summary in summaries:
        for lesson in summary.lessons:
            for form in lesson.forms.values():
                key = (lesson.site, lesson.lesson, form.form)
                found.setdefault(key, Counter())[asked_in[id(form)]] += 1
    return {key: min(asked, key=lambda text: (-asked[text], text))
            for key, asked in found.items()}  # fmt: skip


def _asked(form: FormSums) -> str:
    """What must be equal before two forms can be added. Options that only some chose may differ."""
    items = [
        [meta["id"], meta["type"], str(meta["worth"]), meta["ask"], meta["label"], meta["sure"],
         [[c["option"], c["text"]] for c in meta["choices"] if c.get("text")]]
        for meta in form.items
    ]  # fmt: skip
    whole = [form.has_key, str(form.of), sorted(form.counted), sorted(form.unread), sorted(items)]
    return json.dumps(whole, ensure_ascii=False, sort_keys=True)


def _order(lists: Iterable[tuple[str, ...]]) -> tuple[str, ...]:
    """Groups in the order of most of the summaries that have most groups, the others by name."""
    counts = Counter(lists)
    first = min(counts, key=lambda names: (-len(names), -counts[names], names), default=())
    every = {name for names in counts for name in names}
    return (*first, *sorted(every - {*first}))


def _lesson(lessons: Sequence[LessonSums], groups: Sequence[str]) -> LessonSums:
    """One lesson of all schools."""
    names = {form for lesson in lessons for form in lesson.forms}
    forms = {
        name: _form([lesson.forms[name] for lesson in lessons if name in lesson.forms], groups)
        for name in sorted(names, key=FORMS.index)
    }
    pairs = all_added(lesson.pairs for lesson in lessons)
    of: list[Exact | None] = [lesson.pairs_of for lesson in lessons if lesson.pairs]
    return replace(
        lessons[0],
        forms=forms,
        pairs={group: pairs[group] for group in groups if group in pairs},
        pairs_of=of[0] if of else None,
        same_items=any(lesson.same_items for lesson in lessons if lesson.pairs),
        clusters=tuple(cluster for lesson in lessons for cluster in lesson.clusters),
        classes=all_added(lesson.classes for lesson in lessons),
        table=any(lesson.table for lesson in lessons),
        holds=tuple(sorted({one for lesson in lessons for one in lesson.holds})),
    )


def _form(forms: Sequence[FormSums], groups: Sequence[str]) -> FormSums:
    found = all_added(form.groups for form in forms)
    first = min(forms, key=lambda form: [meta["id"] for meta in form.items])
    by_id: dict[str, list[Mapping[str, Any]]] = {}
    for form in forms:
        for meta in form.items:
            by_id.setdefault(meta["id"], []).append(meta)
    items = tuple({**meta, "choices": _choices(by_id[meta["id"]])} for meta in first.items)
    return replace(
        first,
        items=items,
        groups={group: found[group] for group in groups if group in found},
    )


def _choices(metas: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """The options of all schools: as they stand where all have the same, else by their letters."""
    first = metas[0]["choices"]
    if all(meta["choices"] == first for meta in metas):
        return list(first)
    every = {choice["option"]: choice for meta in metas for choice in meta["choices"]}
    return [every[option] for option in sorted(every, key=lambda o: (o.casefold(), o))]
