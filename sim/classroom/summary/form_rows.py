"""A form of a report from its sums: the same rows as from answer files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import reduce
from itertools import accumulate
from operator import add
from typing import Any

from sim.classroom.refusal import FEWEST
from sim.classroom.report import sentences as say
from sim.classroom.report.items.rows import item_sentence
from sim.classroom.report.items.statistics import NO_NUMBERS, add_numbers, option_curves, whole_test
from sim.classroom.report.talk import talk_rows
from sim.classroom.statistics.spread import Exact, Spread, spread_of
from sim.classroom.summary.sums import FormSums, GroupSums, ItemSums

MOST_LISTED = 20_000
"""Students whose totals are listed one by one, as for a plot; as many as files are read."""


def plain(value: Exact | None) -> int | float | None:
    """A number of marks as it stands in a report: whole where it is."""
    if value is None:
        return None
    found = Fraction(value)
    return found.numerator if found.denominator == 1 else float(found)


def spread_of_totals(totals: Mapping[Exact, int]) -> Spread:
    """Mean and deviation of totals by how many students have each."""
    whole = sum(t * count for t, count in totals.items())
    return spread_of(sum(totals.values()), whole, sum(t * t * count for t, count in totals.items()))


def form_row(
    form: FormSums, groups: Sequence[str], students: list[dict[str, Any]], *, inference: bool
) -> dict[str, Any]:
    """One form. `students`: who it is, empty where that is not known."""
    here = [form.groups[group] for group in groups if group in form.groups]
    items = [_item(meta, here, form) for meta in form.items]
    together: GroupSums | None = reduce(add, here) if here else None
    sums = [together.part(name) for name in form.counted] if together else []
    if together:
        whole = whole_test(
            together.n, sums, together.totals,
            form.of, by_item=bool(form.items),
        )  # fmt: skip
    else:
        whole = {"alpha": None, "delta": None, "sentences": []}
    return {
        "form": form.form,
        "has_key": form.has_key,
        "n": sum(group.listed for group in here),
        "of": plain(form.of),
        "unread": list(form.unread),
        **whole,
        "groups": [
            _group(group, form.groups.get(group), form, inference=inference) for group in groups
        ],
        "students": students,
        "items": items,
        "beliefs": [],
        "words": [],
        "predictions": [],
        "own_runs": [],
        "talk": talk_rows(items),
    }


def _group(
    name: str, group: GroupSums | None, form: FormSums, *, inference: bool
) -> dict[str, Any]:
    totals = dict(sorted(group.totals.items())) if group else {}
    n = sum(totals.values())
    row: dict[str, Any] = {"group": name, "n": n, "totals": []}
    if n <= MOST_LISTED:
        row["totals"] = [float(total) for total, count in totals.items() for _ in range(count)]
    if form.of == 0:
        return row
    if n < FEWEST:
        return {**row, "sentence": say.too_few(n, FEWEST)}
    found = spread_of_totals(totals)
    interval = found.interval() if inference and found.sd else None
    low, high = interval or (None, None)
    return {
        **row, "mean": found.mean, "sd": found.sd, "low": low, "high": high,
        "median": _median(totals, n), "least": float(min(totals)), "most": float(max(totals)),
        "sentence": say.of_mean(found, plain(form.of), interval),
    }  # fmt: skip


def _median(totals: Mapping[Exact, int], n: int) -> float:
    """The middle total, or the middle between the two middle ones."""
    places = list(zip(accumulate(totals.values()), totals, strict=True))
    low, high = (next(t for end, t in places if end > k) for k in ((n - 1) // 2, n // 2))
    return (float(low) + float(high)) / 2


def _item(meta: Mapping[str, Any], groups: Sequence[GroupSums], form: FormSums) -> dict[str, Any]:
    name = meta["id"]
    sums: ItemSums = reduce(add, (group.items[name] for group in groups))
    counts = sums.counts
    row: dict[str, Any] = {
        "id": name, "label": meta["label"], "ask": meta["ask"], "type": meta["type"],
        "worth": plain(meta["worth"]), "n": counts["n"], "answered": counts["answered"],
        "sure": {"right": counts["sure_right"], "wrong": counts["sure_wrong"]}
        if meta["sure"] else None,
        "tries": None, "changed": None, "typed": None,  # nobody hands these on
        **{word: counts[word] for word in ("right", "partly", "wrong", "unread", "empty")},
        "choices": [
            {**choice, "count": sums.chosen.get(choice["option"], 0),
             "sure": sums.sure.get(choice["option"], 0)}
            for choice in meta["choices"]
        ],
        "difficulty": None, "discrimination": None, "point_biserial": None, **NO_NUMBERS,
        "notes": [],
    }  # fmt: skip
    if name in form.counted:
        worth = meta["worth"]
        add_numbers(row, sums.marks, sums.levels, worth)
        option_curves(row, sums.levels, sums.options)
    row["sentence"] = item_sentence(row)
    return row
