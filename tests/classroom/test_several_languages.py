"""A lesson in several languages: each file is marked by the wording that it answers."""

from __future__ import annotations

import itertools
import json
from typing import Any

import pytest

from sim.classroom.files.reading import Reading, Source
from sim.classroom.report.report import Asked, class_report
from sim.lesson.bank import Bank, read_bank
from tests.classroom.given.makers import answers, keys


def bank(language: str) -> Bank:
    """The same questions in other words; what belongs together stands in another order then."""
    pairs = [{"left": f"{language} {n}", "right": f"{language} of {n}"} for n in range(3)]
    options = [{"text": f"{language} a"}, {"text": f"{language} b", "correct": True}]
    return read_bank({"title": "Made up", "items": [
        {"id": "choice", "type": "single", "ask": f"{language}?", "options": options},
        {"id": "pairs", "type": "matching", "ask": f"{language}?", "pairs": pairs},
    ]})  # fmt: skip


BANKS = {language: bank(language) for language in ("English", "Malay", "Tamil")}


def file_of(language: str, student: str) -> Source:
    """All right, in the letters of this language."""
    values = {name: item.key() for name, item in BANKS[language].items.items()}
    right = {"choice": values["choice"]["correct"][0], "pairs": values["pairs"]["pairs"]}
    text = json.dumps(answers(BANKS[language], student, "pre", right))
    return Source(f"{student}.carts.json", text.encode())


def report_of(order: tuple[str, ...], languages: tuple[str, ...]) -> dict[str, Any]:
    sources = [file_of(language, f"RED-FOX-{k}") for k, language in enumerate(languages)]
    sources += [Source(f"{k}.key.json", keys(BANKS[one], ["pre"]).encode())
                for k, one in enumerate(order)]  # fmt: skip
    reading = Reading.of(sources)
    return class_report([(one, "class") for one in reading.files], reading.keys, [], Asked())


@pytest.mark.parametrize("order", list(itertools.permutations(BANKS)))
def test_every_file_has_all_its_marks_whatever_key_comes_first(order: tuple[str, ...]) -> None:
    report = report_of(order, ("English", "Malay", "Tamil", "Malay"))
    (form,) = report["lessons"][0]["forms"]
    assert [row["total"] for row in form["students"]] == [2, 2, 2, 2]
    assert [item["right"] for item in form["items"]] == [4, 4]
    assert form["items"][0]["ask"] == "Malay?"  # texts are those that most students read


@pytest.mark.parametrize("order", list(itertools.permutations(BANKS)))
def test_where_as_many_read_each_language_texts_are_those_of_the_last_key(
    order: tuple[str, ...],
) -> None:
    (form,) = report_of(order, tuple(BANKS))["lessons"][0]["forms"]
    assert form["items"][0]["ask"] == f"{order[-1]}?"


def test_without_the_key_of_its_language_a_file_has_no_marks() -> None:
    report = report_of(("English",), ("English", "Malay"))
    (form,) = report["lessons"][0]["forms"]
    assert [item["right"] for item in form["items"]] == [1, 1]


def predicted(student: str, kind: str, value: Any, said: str, sure: bool = False) -> Source:
    """A worksheet with one prediction, in the words of the page that it was made on."""
    made = answers(BANKS["English"], student, "worksheet", {})
    row = {"id": "bump", "hash": "", "type": kind, "value": value, "first": "2026-01-01T08:00:00Z",
           "last": "2026-01-01T08:00:00Z", "tries": 1, "said": said, "asked": "?"}  # fmt: skip
    made["items"] = [row | ({"sure": "sure"} if sure else {})]
    return Source(f"{student}.carts.json", json.dumps(made).encode())


def answers_of(files: list[Source]) -> list[tuple[str, int, int]]:
    reading = Reading.of(files)
    report = class_report([(one, "class") for one in reading.files], reading.keys, [], Asked())
    ((row,),) = [form["predictions"] for form in report["lessons"][0]["forms"]]
    return [(one["said"], one["count"], one["sure"]) for one in row["answers"]]


def test_a_choice_is_counted_with_the_same_one_in_another_language() -> None:
    files = [
        predicted("FOX-1", "choice", "0", "They stop."),
        predicted("FOX-2", "choice", "1", "They go on.", sure=True),
        predicted("FOX-3", "choice", "1", "They go on."),
        predicted("FOX-4", "choice", "1", "Mereka terus bergerak.", sure=True),
    ]
    assert answers_of(files) == [("They go on.", 3, 2), ("They stop.", 1, 0)]


def arrows(a: float, b: float) -> list[dict[str, Any]]:
    return [{"pair": "A-B", "on": "A", "share": a}, {"pair": "A-B", "on": "B", "share": b}]


@pytest.mark.parametrize(
    ("a", "b", "said"),
    [
        (0.5, 0.9, "the force on B by A is larger than the force on A by B."),
        (0.9, 0.5, "the force on A by B is larger than the force on B by A."),
        (0.7, 0.72, "both forces are equally large."),
        (0, 0.4, "only the force on B by A."),
        (0, 0, "no force on either."),
    ],
)
def test_arrows_are_told_in_the_language_of_the_report(a: float, b: float, said: str) -> None:
    files = [
        predicted("FOX-1", "arrows", arrows(a, b), "daya pada B …"),
        predicted("FOX-2", "arrows", arrows(a, b), said),
    ]
    assert answers_of(files) == [(said, 2, 0)]


def test_arrows_that_cannot_be_told_keep_the_words_of_their_page() -> None:
    values = [
        [
            {"pair": "A-right", "on": "A", "share": 0.5},
            {"pair": "A-right", "on": "right", "share": 1},
        ],
        [{"pair": "A-B", "on": "A", "size": 2.5}, {"pair": "A-B", "on": "B", "size": 2.5}],
        arrows(0.5, 0.5)[:1],
        [1],
    ]
    files = [predicted(f"FOX-{k}", "arrows", one, f"as said {k}") for k, one in enumerate(values)]
    assert answers_of(files) == [(f"as said {k}", 1, 0) for k in range(len(values))]


@pytest.mark.parametrize(("site", "lesson"), [("elsewhere", "L1"), ("tests", "my-copy")])
def test_a_key_of_a_copy_of_the_lesson_marks_files_of_the_original(site: str, lesson: str) -> None:
    key = json.loads(keys(BANKS["English"], ["pre"])) | {"site": site, "lesson": lesson}
    sources = [file_of(language, f"RED-FOX-{language}") for language in ("English", "Malay")]
    reading = Reading.of([*sources, Source("copy.key.json", json.dumps(key).encode())])
    made = class_report([(one, "class") for one in reading.files], reading.keys, [], Asked())
    (form,) = made["lessons"][0]["forms"]
    assert [item["right"] for item in form["items"]] == [1, 1]  # the other has other questions


def test_a_key_of_other_questions_marks_nothing() -> None:
    other = read_bank({"title": "Other", "items": [
        {"id": "choice", "type": "single", "ask": "Else?",
         "options": [{"text": "x"}, {"text": "y", "correct": True}]},
    ]})  # fmt: skip
    key = json.loads(keys(other, ["pre"])) | {"site": "elsewhere"}
    sources = [file_of("English", "RED-FOX-1"), Source("k.json", json.dumps(key).encode())]
    reading = Reading.of(sources)
    made = class_report([(one, "class") for one in reading.files], reading.keys, [], Asked())
    (form,) = made["lessons"][0]["forms"]
    assert [row["total"] for row in form["students"]] == [None]
