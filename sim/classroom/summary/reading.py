"""A summary read back: everything is bounded and checked, for it comes from somebody else."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from sim.classroom.refusal import FEWEST
from sim.classroom.report.items.rows import question_label
from sim.classroom.statistics.item_numbers import ItemMarks, Levels
from sim.classroom.statistics.pair_sums import PairSums
from sim.classroom.statistics.spread import Exact
from sim.classroom.summary.handed_on import Summary
from sim.classroom.summary.numbers import SummaryError, count, exact
from sim.classroom.summary.once import fingerprint
from sim.classroom.summary.sums import COUNTS, FORMS, FormSums, GroupSums, ItemSums, LessonSums
from sim.classroom.summary.written import FORMAT, KIND, PAIR_NUMBERS
from sim.scene.said import said, template

MOST_BYTES = 20_000_000
MOST_PARTS = 2_000
"""Lessons, forms, groups, items, options, or different totals: of each in one place."""

MOST_SUMMARIES = 100_000
LONGEST = 5_000
DAMAGED = template("this summary is damaged")
T = TypeVar("T")


def read_summary(content: bytes) -> Summary:
    """The summary in a file; raises `SummaryError`."""
    if len(content) > MOST_BYTES:
        raise SummaryError("this file is too large to be a summary")
    try:
        found = json.loads(content.decode("utf-8-sig"))
    except (ValueError, RecursionError):
        raise SummaryError("this is no summary: it is no JSON") from None
    if not isinstance(found, dict) or found.get("kind") != KIND:
        raise SummaryError("this is no summary of `carts class --summary`")
    if found.get("format") != FORMAT:
        raise SummaryError("this summary comes from another version of Newton's Carts")
    try:
        return Summary(
            tuple(map(_text, _list(found["groups"]))),
            tuple(map(_lesson, _list(found["lessons"]))),
            count(found["withheld"]),
        )
    except SummaryError:
        raise
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError, RecursionError):
        raise SummaryError(DAMAGED) from None


def _list(value: object) -> list[Any]:
    if not isinstance(value, list) or len(value) > MOST_PARTS:
        raise SummaryError(DAMAGED)
    return value


def _table(value: object) -> dict[str, Any]:
    if not isinstance(value, dict) or len(value) > MOST_PARTS:
        raise SummaryError(DAMAGED)
    return value  # names are text in JSON


def _map(value: object, made: Callable[[Any], T]) -> dict[str, T]:
    return {name: made(inner) for name, inner in _table(value).items()}


def _text(value: object) -> str:
    if not isinstance(value, str) or len(value) > LONGEST:
        raise SummaryError(DAMAGED)
    return value


def _lesson(row: Mapping[str, Any]) -> LessonSums:
    forms = list(map(_form, _list(row["forms"])))
    return LessonSums(
        site=_text(row["site"]), lesson=_text(row["lesson"]), table=bool(row["table"]),
        forms={form.form: form for form in forms}, pairs=_map(row["pairs"], _pair),
        pairs_of=None if row["pairs_of"] is None else exact(row["pairs_of"]),
        same_items=bool(row["same_items"]), classes=_map(row["classes"], count),
        clusters=tuple(_map(cluster, _pair) for cluster in row["clusters"]),
        holds=_holds(row["holds"]) if "holds" in row else (fingerprint(row),),
    )  # fmt: skip


def _holds(value: object) -> tuple[str, ...]:
    """Of a whole country: more than there may be of anything else in one place."""
    found = value if isinstance(value, list) else []
    if not 0 < len(found) <= MOST_SUMMARIES:
        raise SummaryError(DAMAGED)
    return tuple(map(_text, found))


def _pair(row: Mapping[str, Any]) -> PairSums:
    numbers: dict[str, Any] = {
        name: exact(row[name]) if name in ("x", "y", "xx", "yy", "xy", "shares")
        else count(row[name])
        for name in PAIR_NUMBERS
    }  # fmt: skip
    found = PairSums(**numbers, differences=_histogram(row["differences"]))
    _enough(found.n)
    if sum(found.differences.values()) != found.n or found.gained > found.n:
        raise SummaryError("the sums of those who took both tests do not fit together")
    if found.n * found.xx < found.x**2 or found.n * found.yy < found.y**2:
        raise SummaryError("the sums of those who took both tests do not fit together")
    return found


def _enough(n: int) -> None:
    if n < FEWEST:
        raise SummaryError(said("it holds a group of fewer than {n} students", n=f"{FEWEST}"))


def _histogram(row: object) -> dict[Exact, int]:
    found = {exact(value): count(n) for value, n in _table(row).items()}
    if 0 in found.values():
        raise SummaryError(DAMAGED)
    return found


def _form(row: Mapping[str, Any]) -> FormSums:
    items = tuple(_meta(k, meta) for k, meta in enumerate(_list(row["items"]), 1))
    names = {meta["id"] for meta in items}
    form = FormSums(
        form=_text(row["form"]), has_key=bool(row["has_key"]),
        of=None if row["of"] is None else exact(row["of"]),
        counted=tuple(map(_text, _list(row["counted"]))),
        unread=tuple(map(_text, _list(row["unread"]))),
        items=items, groups=_map(row["groups"], _group),
    )  # fmt: skip
    fits = all(group.items.keys() == names for group in form.groups.values())
    if not fits or not names >= {*form.counted} or len(names) < len(items):
        raise SummaryError(said("the questions of the form {form} do not fit together",
                                form=form.form[:40]))  # fmt: skip
    if form.form not in FORMS or (form.of is not None and form.of < 0) or not form.groups:
        raise SummaryError(DAMAGED)
    return form


def _meta(number: int, row: Mapping[str, Any]) -> dict[str, Any]:
    """What a question asks; its number is a sentence again, to be told in any language."""
    kept: dict[str, Any] = {name: _text(row[name]) for name in ("id", "label", "ask", "type")}
    choices = [
        {**{name: _text(choice[name]) for name in choice if name != "correct"},
         **({"correct": bool(choice["correct"])} if "correct" in choice else {})}
        for choice in _list(row["choices"])
    ]  # fmt: skip
    if any("option" not in choice or "label" not in choice for choice in choices):
        raise SummaryError(DAMAGED)
    worth = exact(row["worth"])
    if worth < 0:
        raise SummaryError(DAMAGED)
    if kept["label"] == question_label(number):
        kept["label"] = question_label(number)
    return {**kept, "worth": worth, "sure": bool(row["sure"]), "choices": choices}


def _group(row: Mapping[str, Any]) -> GroupSums:
    found = GroupSums(
        listed=count(row["listed"]), totals=_histogram(row["totals"]),
        items=_map(row["items"], _item),
        parts=_map(row["parts"], _part) if "parts" in row else None,
    )  # fmt: skip
    _enough(found.n)
    if found.parts is not None and not found.parts.keys() <= found.items.keys():
        raise SummaryError(DAMAGED)
    if found.listed < found.n:
        raise SummaryError(DAMAGED)
    return found


def _part(row: object) -> tuple[Exact, Exact]:
    m, mm = map(exact, _list(row))
    return m, mm


def _item(row: Mapping[str, Any]) -> ItemSums:
    n, *sums = _list(row["marks"])
    m, mm, t, tt, mt = map(exact, sums)
    given = row["counts"]
    return ItemSums(
        counts={name: count(given[name]) for name in COUNTS},
        chosen=_map(row["chosen"], count), sure=_map(row["sure"], count),
        marks=ItemMarks(count(n), m, mm, t, tt, mt), levels=_levels(row["levels"], n),
        options=None if row["options"] is None else _map(row["options"], _histogram),
    )  # fmt: skip


def _levels(row: object, students: int) -> Levels | None:
    if row is None:
        return None
    found = {exact(total): (count(n), exact(marks)) for total, (n, marks) in _table(row).items()}
    numbers = [n for n, _ in found.values()]
    if 0 in numbers or sum(numbers) != students:
        raise SummaryError("the marks by total do not fit together")
    return found
