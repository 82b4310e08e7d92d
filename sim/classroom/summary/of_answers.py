"""Sums from marked answer files: per item and group, and nothing about a single student.

Who answered another wording of a question has no total, and is in no sum of an item either: with
all sums of one item and those of counted students, the difference would be that student's marks.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from sim.classroom.files.keyed import KeyedForm
from sim.classroom.report.flags.sorted_out import ORDER
from sim.classroom.report.items.rows import item_rows
from sim.classroom.report.marked import Marked, counted_items, worth
from sim.classroom.report.pairing import pair_up
from sim.classroom.statistics.spread import Exact
from sim.classroom.summary.of_marks import item_sums
from sim.classroom.summary.sums import COUNTS, FormSums, GroupSums, ItemSums, LessonSums

Keys = Mapping[tuple[str, str, str], KeyedForm]


def lessons_of(
    files: Sequence[Marked], keys: Keys, groups: Sequence[str], classes: Mapping[str, int]
) -> list[LessonSums]:
    """The sums of files that count, lesson by lesson. Forms without a key have only a number."""
    lessons: dict[tuple[str, str], list[Marked]] = {}
    for file in files:
        lessons.setdefault((file.file.site, file.file.lesson), []).append(file)
    return [
        _lesson(site, lesson, found, keys, groups, classes)
        for (site, lesson), found in sorted(lessons.items())
    ]


def _lesson(
    site: str,
    lesson: str,
    files: Sequence[Marked],
    keys: Keys,
    groups: Sequence[str],
    classes: Mapping[str, int],
) -> LessonSums:
    by_form = {form: [f for f in files if f.file.form == form] for form in ORDER}
    by_form = {form: found for form, found in by_form.items() if found}
    pairs = {}
    if {"pre", "post"} <= by_form.keys():
        made = {group: pair_up(by_form["pre"], by_form["post"], group) for group in groups}
        pairs = {group: found for group, found in made.items() if found is not None}
    first = next(iter(pairs.values()), None)
    return LessonSums(
        site=site,
        lesson=lesson,
        forms={
            form: _form(form, found, keys.get((site, lesson, form)), groups)
            for form, found in by_form.items()
        },
        pairs={group: found.sums for group, found in pairs.items()},
        pairs_of=int(first.of) if first else None,
        same_items=first.same_items if first else False,
        classes={group: classes.get(group, 1) for group in groups},
    )


def _form(
    form: str, files: Sequence[Marked], key: KeyedForm | None, groups: Sequence[str]
) -> FormSums:
    good = [file for file in files if not file.foreign]
    counted = counted_items(good) if key else ()
    metas = tuple(map(meta_of, item_rows(files, key, counted))) if key else ()
    return FormSums(
        form=form,
        has_key=key is not None,
        of=worth(good, counted),
        counted=counted,
        unread=tuple(sorted({name for file in good for name in file.waiting})),
        items=metas,
        groups={
            group: _group([f for f in files if f.group == group], key, counted)
            for group in groups
        },
    )  # fmt: skip


def meta_of(row: Mapping[str, Any]) -> dict[str, Any]:
    """What an item asks, without what anybody answered."""
    kept = {name: row[name] for name in ("id", "label", "ask", "type", "worth")}
    choices = [
        {name: value for name, value in choice.items() if name not in ("count", "sure")}
        for choice in row["choices"]
    ]
    return {**kept, "sure": row["sure"] is not None, "choices": choices}


def _group(files: Sequence[Marked], key: KeyedForm | None, counted: Sequence[str]) -> GroupSums:
    good = [file for file in files if not file.foreign]
    rows = item_rows(good, key, counted) if key else []
    return GroupSums(
        listed=len(files),
        totals=Counter[Exact](file.total(counted) for file in good),
        items={row["id"]: _item(row, good, counted) for row in rows},
    )


def _item(row: Mapping[str, Any], files: Sequence[Marked], counted: Sequence[str]) -> ItemSums:
    name = row["id"]
    mine = [f for f in files if name in f.answers]
    sure = row["sure"] or {"right": 0, "wrong": 0}
    counts = {word: row[word] for word in COUNTS[:7]}
    found = item_sums(
        {**counts, "sure_right": sure["right"], "sure_wrong": sure["wrong"]},
        [f.answers[name].marks for f in mine] if name in counted else [],
        [f.total(counted) for f in mine] if name in counted else [],
    )
    return found.choosing(
        {choice["option"]: choice["count"] for choice in row["choices"]},
        {choice["option"]: choice["sure"] for choice in row["choices"]},
    )
