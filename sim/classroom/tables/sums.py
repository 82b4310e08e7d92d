"""Tables as one lesson: exact sums for the report, and whose marks they are."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from sim.classroom.report.items.choices import letter
from sim.classroom.statistics.pair_sums import PairSums, pair_sums
from sim.classroom.statistics.spread import Exact
from sim.classroom.summary.of_marks import item_sums
from sim.classroom.summary.sums import COUNTS, FormSums, GroupSums, LessonSums, added
from sim.classroom.tables.taken import ALONE, Taken

FORMS = ("pre", "post", "delayed", ALONE)


def lesson_of(
    name: str,
    taken: Sequence[Taken],
    groups: Sequence[str],
    keys: Mapping[str, tuple[str, ...]],
    *,
    letters: bool,
    most: Exact | None,
) -> LessonSums:
    """All sums. `taken`: what counts, one for each student and form; `most`: of totals."""
    forms = {
        form: _form(form, mine, taken, groups, keys, letters=letters, most=most)
        for form in FORMS
        if (mine := [row for row in taken if row.form == form])
    }
    pairs, clusters = _pairs(taken, groups, forms)
    classes = {
        group: len({row.klass for row in taken if row.group == group and row.klass}) or 1
        for group in groups
    }
    return LessonSums(
        site="", lesson=name, forms=forms, pairs=pairs, clusters=clusters, classes=classes,
        pairs_of=forms["pre"].of if pairs else None, same_items=bool(pairs) and _same(forms),
        table=True,
    )  # fmt: skip


def _form(
    form: str, taken: Sequence[Taken], everything: Sequence[Taken], groups: Sequence[str],
    keys: Mapping[str, tuple[str, ...]], *, letters: bool, most: Exact | None,
) -> FormSums:  # fmt: skip
    names = list(dict.fromkeys(name for row in taken for name in row.items))
    names = [n for n in names if any(row.items.get(n) is not None or n in row.chosen
                                     for row in taken)]  # fmt: skip
    worth = {name: _worth(name, taken, everything, keys, letters=letters) for name in names}
    counted = tuple(name for name in names if worth[name])
    options = {
        name: sorted({row.chosen[name] for row in taken if name in row.chosen}, key=str.casefold)
        for name in names
    }
    metas = tuple(
        {
            "id": name, "label": name, "ask": "", "type": "single" if letters else "mark",
            "worth": worth[name], "sure": False,
            "choices": [
                {"option": o, "label": letter(o), "text": "", "belief": "", "says": "",
                 "correct": o.casefold() in keys.get(name, ())}
                for o in options[name]
            ],
        }
        for name in names
    )  # fmt: skip
    of = sum(worth.values(), 0) if names else _most(taken, most)
    return FormSums(
        form=form, has_key=bool(keys) or not letters, of=of, counted=counted, unread=(),
        items=metas,
        groups={
            group: _group([row for row in taken if row.group == group], names, worth)
            for group in groups
        },
    )  # fmt: skip


def _worth(
    name: str, taken: Sequence[Taken], everything: Sequence[Taken], keys: Mapping[str, Any], *,
    letters: bool,
) -> Exact:  # fmt: skip
    """The most marks: told by the table, or 1 for marks up to 1, or the highest mark given in any
    test of the lesson: that nobody was quite right before makes no question worth less."""
    if letters:
        return int(name in keys)
    if told := [row.most[name] for row in taken if name in row.most]:
        return max(told)
    return max(1, *(max(row.items.get(name) or 0, row.most.get(name, 0)) for row in everything))


def _most(taken: Sequence[Taken], most: Exact | None) -> Exact | None:
    told = {row.of for row in taken}
    return told.pop() if len(told) == 1 and None not in told else most


def _group(taken: Sequence[Taken], names: Sequence[str], worth: Mapping[str, Exact]) -> GroupSums:
    totals = [row.marks for row in taken]
    items = {}
    for name in names:
        marks = [row.items.get(name) for row in taken]
        right = sum(m == worth[name] for m in marks) if worth[name] else 0
        partly = sum(m is not None and 0 < m < worth[name] for m in marks)
        given = sum(row.items.get(name) is not None or name in row.chosen for row in taken)
        counts = {
            **dict.fromkeys(COUNTS, 0), "n": len(taken), "answered": given, "right": right,
            "partly": partly, "wrong": given - right - partly if worth[name] else 0,
            "empty": len(taken) - given,
        }  # fmt: skip
        items[name] = item_sums(
            counts, [m or 0 for m in marks], totals, [row.chosen.get(name, "") for row in taken]
        )
    return GroupSums(listed=len(taken), totals=Counter(totals), items=items)


def _same(forms: Mapping[str, FormSums]) -> bool:
    names = [{meta["id"] for meta in forms[form].items} for form in ("pre", "post")]
    return bool(names[0]) and names[0] == names[1]


def _pairs(
    taken: Sequence[Taken], groups: Sequence[str], forms: Mapping[str, FormSums]
) -> tuple[dict[str, PairSums], tuple[dict[str, PairSums], ...]]:
    """Students with both tests by group, and class by class where every one of them has a class."""
    if not {"pre", "post"} <= forms.keys() or forms["pre"].of != forms["post"].of:
        return {}, ()
    of = forms["pre"].of
    if of == 0:
        return {}, ()
    before, after = ({row.person: row for row in taken if row.form == f} for f in ("pre", "post"))
    both: dict[tuple[str, str], list[tuple[Taken, Taken]]] = {}
    for person in before.keys() & after.keys():
        row = before[person]
        both.setdefault((row.klass, row.group), []).append((row, after[person]))
    sums = {
        place: pair_sums([a.marks for a, _ in rows], [b.marks for _, b in rows], of)
        for place, rows in sorted(both.items())
    }
    pairs = {group: pair_sums([], [], of) for group in groups}
    clusters: dict[str, dict[str, PairSums]] = {}
    for (klass, group), found in sums.items():
        pairs = added(pairs, {group: found})
        if klass:
            clusters.setdefault(klass, {})[group] = found
    return pairs, tuple(clusters.values())
