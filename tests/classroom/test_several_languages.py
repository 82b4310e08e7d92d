"""A lesson in several languages: each file is marked by the wording that it answers."""

from __future__ import annotations

import itertools
import json
from typing import Any

import pytest

from sim.classroom.files.reading import Reading, Source
from sim.classroom.report.report import Asked, class_report
from sim.lesson.bank import Bank, read_bank
from tests.classroom.makers import answers, keys


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
    assert form["items"][0]["ask"] == f"{order[-1]}?"  # texts are those of the last key


def test_without_the_key_of_its_language_a_file_has_no_marks() -> None:
    report = report_of(("English",), ("English", "Malay"))
    (form,) = report["lessons"][0]["forms"]
    assert [item["right"] for item in form["items"]] == [1, 1]
