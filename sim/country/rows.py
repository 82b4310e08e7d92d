"""A file of answers as rows of the table, marked by the code that marks a class."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime
from typing import Any

from sim.classroom.files.archive import shown
from sim.classroom.files.keyed import KeyedForm, KeyedItem
from sim.classroom.files.marks_file import pseudonym
from sim.classroom.report.flags.sorted_out import digest
from sim.classroom.report.flags.times import moment_of
from sim.classroom.report.items.choices import chose_option
from sim.classroom.report.items.typed_numbers import shown_wrong, typed_wrong
from sim.classroom.report.marked import NO_CODE, Answer, Marked
from sim.classroom.report.prediction_meaning import words_of
from sim.country.schema import NAMES
from sim.lesson.answer_file import PREDICTIONS, Item
from sim.lesson.csv_text import as_text, safe_text
from sim.lesson.kinds.number import Number
from sim.lesson.mark import is_empty

DIGITS = 16
"""Hexadecimal digits of a digest: among 10⁷ files two are alike by chance once in 400,000 times."""

BETWEEN = ";"  # not "|": Spark splits at a regular expression
OPTIONS = ("single", "multiple", "idea")

OF_FILE = NAMES[: NAMES.index("item")]
OF_ANSWER = NAMES[NAMES.index("item") :]
"""The first columns say of which file an answer is, the others what it is."""

Row = tuple[Any, ...]


@dataclass(frozen=True, slots=True)
class Place:
    """Where a file stands: the group with its place, the class, and the file's own place."""

    group: str
    group_order: int
    klass: str
    order: int


def rows_of(file: Marked, place: Place, key: KeyedForm | None) -> list[Row]:
    """All rows of a file, in the order of `schema.COLUMNS`."""
    found = list(_answers(file, key)) or [_NOBODY]
    whole = _of_file(file, place, key)
    whole["sheet_rows"] = len(found)
    head = tuple(whole[name] for name in OF_FILE)
    return [(*head, *map(one.get, OF_ANSWER)) for one in found]


def _of_file(file: Marked, place: Place, key: KeyedForm | None) -> dict[str, Any]:
    f = file.file
    timed = digest(file, times=True)[:DIGITS]
    name = safe_text(file.name)
    own = f"{place.order}\0{name}\0{f.student}\0{timed}"
    sheet = hashlib.sha256(own.encode()).hexdigest()[:DIGITS]
    person = pseudonym(f.student) or f"{NO_CODE} {sheet}"
    return {
        "sheet": sheet,
        "sheet_order": place.order, "file": name, "site": safe_text(f.site),
        "lesson": safe_text(f.lesson), "lesson_hash": safe_text(f.lesson_hash), "form": f.form,
        "group": safe_text(shown(place.group)), "group_order": place.group_order,
        "class": safe_text(shown(place.klass)) if place.klass else "",
        "student": safe_text(f.student), "person": safe_text(person),
        "created": _moment(f.created), "saved": _moment(f.saved),
        "digest": digest(file, times=False)[:DIGITS], "digest_timed": timed,
        "keyed": key is not None,
    }  # fmt: skip


def _moment(text: str | None) -> datetime | None:
    return moment_of(text) if text else None


_NOBODY: dict[str, Any] = {"answered": False, "chosen": "", "beliefs": "", "foreign": False,
                           "sure": ""}  # fmt: skip


def _answers(file: Marked, key: KeyedForm | None) -> Iterator[dict[str, Any]]:
    """Answers that a key knows in its order, then predictions and what it does not know."""
    for k, answer in enumerate(file.answers.values(), 1):
        if key:
            yield {**_answer(answer, key.items[answer.id]), "position": k}
        else:
            yield _answer(answer, None)
    for name, item in file.file.latest().items():
        if name not in file.answers:
            plain = Answer(id=name, type=item.type, value=item.value,
                           sure=item.more.get("sure", ""), mark=None, item=item)  # fmt: skip
            yield _answer(plain, None)


def _answer(answer: Answer, keyed: KeyedItem | None) -> dict[str, Any]:
    mark, value = answer.mark, answer.value
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return {
        "item": answer.id, "type": answer.type,
        "value": None if value is None else as_text(value) if number else safe_text(as_text(value)),
        "number": float(value) if number else None,
        "answered": not is_empty(value),
        "chosen": BETWEEN.join(map(safe_text, _chosen(answer, keyed))),
        "beliefs": BETWEEN.join(map(safe_text, mark.beliefs)) if mark else "",
        "verdict": mark.verdict if mark else None,
        "marks": mark.marks if mark else None,
        "worth": answer.worth if mark else None,
        "foreign": answer.foreign, "sure": safe_text(answer.sure),
        **(_of_item(answer.item) if answer.item else {}),
    }  # fmt: skip


def _of_item(item: Item) -> dict[str, Any]:
    said: dict[str, Any] = {}
    if item.type in PREDICTIONS:
        texts = ("said", "why", "asked")
        said = {name: safe_text(item.more[name]) for name in texts if name in item.more}
        said["locked"] = "locked" in item.more
        said["again"] = _moment(item.more.get("again"))
    return {
        "hash": item.hash, "first": _moment(item.first), "last": _moment(item.last),
        "tries": item.tries, **said,
    }  # fmt: skip


def _chosen(answer: Answer, keyed: KeyedItem | None) -> Iterator[str]:
    """The options that this answer is counted under in a report."""
    if answer.item and answer.type in PREDICTIONS:
        if answer.type != "curve":
            yield words_of(answer.item)
        return
    if keyed is None:
        if answer.type == "single" and isinstance(answer.value, str):
            yield answer.value
        return
    question = keyed.question
    if isinstance(question, Number):
        if wrong := typed_wrong(answer, question):
            yield shown_wrong(wrong, question)
    elif question.KIND in OPTIONS:
        yield from (o for o in question.asked()["options"] if chose_option(answer, o))
