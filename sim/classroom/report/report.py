"""The whole report of a class as plain values: what `carts class --json` prints.

The same report is made in the page and on the command line.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

from sim.classroom.files.keyed import KeyedForm
from sim.classroom.files.marks_file import Given
from sim.classroom.files.reading import MOST_NAMED, Read, Refused
from sim.classroom.refusal import FEWEST
from sim.classroom.report import sentences as say
from sim.classroom.report.beliefs import belief_rows, word_rows
from sim.classroom.report.flags.sorted_out import ORDER, Sorted, sort_out
from sim.classroom.report.gain_report import comparison_table, gain_table, only_after_table
from sim.classroom.report.items.rows import item_rows
from sim.classroom.report.items.statistics import whole_test
from sim.classroom.report.marked import (
    Keys,
    Marked,
    counted_items,
    lesson_title,
    mark_file,
    told_apart,
    worth,
)
from sim.classroom.report.notes import notes_of
from sim.classroom.report.numerals import in_order
from sim.classroom.report.own_runs import own_run_rows
from sim.classroom.report.pairing import Pairs, pair_up
from sim.classroom.report.predictions import prediction_rows
from sim.classroom.report.talk import talk_rows
from sim.classroom.report.topics import topic_differences, topic_rows, topic_sums
from sim.classroom.statistics.spread import Exact, Spread, median, spread
from sim.scene.said import template

FORMAT = 1
KIND = "newtons-carts-class"
WHOLE = template("class")
"""The name of the group where the teacher named none."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Asked:
    """What the teacher asked for. `groups` in their order; `classes`: how many each one holds."""

    groups: tuple[str, ...] = (WHOLE,)
    classes: Mapping[str, int] = field(default_factory=dict)
    given: Given = field(default_factory=dict)
    now: str = ""
    inference: bool = True


def class_report(
    files: Iterable[tuple[Read, str]],
    keys: Sequence[KeyedForm],
    refused: Sequence[Refused],
    asked: Asked,
) -> dict[str, Any]:
    """The report on files, each with the name of its group."""
    of_files = Keys(keys)
    sorted_out = sorted_files(files, of_files, asked)
    forms = of_files.main  # with those of copies that files were marked by
    lessons: dict[tuple[str, str], list[Marked]] = {}
    for file in sorted_out.counted:
        lessons.setdefault((file.file.site, file.file.lesson), []).append(file)
    tables = told_apart(
        _lesson(site, lesson, found, forms, asked)
        for (site, lesson), found in sorted(lessons.items())
    )
    return {
        "format": FORMAT,
        "kind": KIND,
        "files": {
            "read": len(sorted_out.counted) + len(sorted_out.set_aside),
            "counted": len(sorted_out.counted),
            "set_aside": [file.name for file in sorted_out.set_aside],
            "refused": [asdict(row) for row in refused[:MOST_NAMED]],
            "refused_more": max(0, len(refused) - MOST_NAMED),
        },
        "keys": sorted({f"{key.lesson} {key.form}" for key in keys}),
        "groups": list(asked.groups),
        "inference": asked.inference,
        "flags": [asdict(flag) for flag in sorted_out.flags],
        "notes": notes_of(tables),
        "lessons": tables,
    }


def sorted_files(files: Iterable[tuple[Read, str]], keys: Keys, asked: Asked) -> Sorted:
    """The files with their marks: which count, which wait for the teacher."""
    marked = [mark_file(read, group, keys.of(read.answers), asked.given) for read, group in files]
    return sort_out(marked, asked.now)


def _lesson(
    site: str,
    lesson: str,
    files: Sequence[Marked],
    keys: Mapping[tuple[str, str, str], KeyedForm],
    asked: Asked,
) -> dict[str, Any]:
    by_form = {form: [f for f in files if f.file.form == form] for form in ORDER}
    by_form = {form: found for form, found in by_form.items() if found}
    tables = [
        _form(form, found, keys.get((site, lesson, form)), asked) for form, found in by_form.items()
    ]
    pairs = _pairs(by_form, asked)
    topics = list(topic_sums(by_form, keys.get((site, lesson, "pre")), asked.groups))
    gains = [gain_table(p, inference=asked.inference) for p in pairs if p.students]
    return {
        "site": site,
        "lesson": lesson,
        "title": lesson_title(lesson, (keys.get((site, lesson, form)) for form in by_form)),
        "forms": tables,
        "gains": gains,
        "topics": topic_rows(topics),
        "topic_differences": topic_differences(topics, asked.groups) if asked.inference else [],
        "comparison": _comparison(pairs, asked),
        "later": _later(by_form, asked),
    }


def _form(
    form: str, files: Sequence[Marked], key: KeyedForm | None, asked: Asked
) -> dict[str, Any]:
    good = [file for file in files if not file.foreign]
    counted = counted_items(good) if key else ()
    unread = sorted({name for file in good for name in file.waiting})
    items = item_rows(files, key, counted)
    return {
        "form": form,
        "has_key": key is not None,
        "n": len(files),
        "of": worth(good, counted),
        "unread": unread,
        **_whole_test(good, counted),
        "groups": [_group(group, good, counted, asked) for group in asked.groups],
        "students": [
            _student(file, counted, has_key=key is not None)
            for file in sorted(
                files, key=lambda f: (asked.groups.index(f.group), in_order(f.student))
            )
        ],
        "items": items,
        "beliefs": belief_rows(files, key),
        "words": word_rows(files, key),
        "predictions": prediction_rows(good),
        "own_runs": own_run_rows(good, key),
        "talk": talk_rows(items),
    }


def _whole_test(files: Sequence[Marked], counted: Sequence[str]) -> dict[str, Any]:
    marks = [[file.answers[name].marks for file in files] for name in counted]
    sums = [(sum(column), sum(m * m for m in column)) for column in marks]
    totals = Counter[Exact](file.total(counted) for file in files)
    return whole_test(len(files), sums, totals, worth(files, counted))


def _group(
    group: str, files: Sequence[Marked], counted: Sequence[str], asked: Asked
) -> dict[str, Any]:
    totals = [float(f.total(counted)) for f in files if f.group == group]
    of = worth(files, counted)
    row: dict[str, Any] = {"group": group, "n": len(totals), "totals": sorted(totals)}
    if not of:
        return row
    if len(totals) < FEWEST:
        return {**row, "sentence": say.too_few(len(totals), FEWEST)}
    found = spread(totals)
    interval = found.interval() if asked.inference and found.sd else None
    low, high = interval or (None, None)
    return {
        **row, "mean": found.mean, "sd": found.sd, "low": low, "high": high,
        "median": median(totals), "least": min(totals), "most": max(totals),
        "sentence": say.of_mean(found, of, interval),
    }  # fmt: skip


def _student(file: Marked, counted: Sequence[str], *, has_key: bool) -> dict[str, Any]:
    whole = has_key and not file.foreign
    return {
        "student": file.who, "group": file.group, "file": file.name,
        "total": file.total(counted) if whole else None,
        "marks": [a.mark.marks if a.mark and a.worth and not a.foreign else None
                  for a in file.answers.values()] if has_key else [],
        "open": list(file.open), "waiting": list(file.waiting), "foreign": list(file.foreign),
        "saved": file.file.saved,
    }  # fmt: skip


def _pairs(by_form: Mapping[str, Sequence[Marked]], asked: Asked) -> list[Pairs]:
    if "pre" not in by_form or "post" not in by_form:
        return []
    made = [pair_up(by_form["pre"], by_form["post"], group) for group in asked.groups]
    return [pairs for pairs in made if pairs is not None]


def _comparison(pairs: Sequence[Pairs], asked: Asked) -> dict[str, Any] | None:
    if len(pairs) != 2:
        return None
    return comparison_table(pairs[0], pairs[1], classes=_classes(asked), inference=asked.inference)


def _classes(asked: Asked) -> int:
    return min((asked.classes.get(group, 1) for group in asked.groups), default=1)


def _later(by_form: Mapping[str, Sequence[Marked]], asked: Asked) -> list[dict[str, Any]]:
    """Two groups on the delayed form, and on others that have no pair."""
    if len(asked.groups) != 2 or not asked.inference:
        return []
    alone = [form for form in by_form if form != "worksheet"]
    if "pre" in by_form and "post" in by_form:
        alone = [form for form in alone if form not in ("pre", "post")]
    tables = []
    for form in alone:
        files = [file for file in by_form[form] if not file.foreign]
        counted = counted_items(files)
        if not worth(files, counted):
            continue
        totals = [[float(f.total(counted)) for f in files if f.group == g] for g in asked.groups]
        if all(totals):
            spreads: list[Spread] = [spread(group) for group in totals]
            groups = (asked.groups[0], asked.groups[1])
            tables.append(only_after_table(form, spreads, groups, classes=_classes(asked)))
    return tables
