"""Flags are questions, and nothing is silently counted."""

from __future__ import annotations

from typing import Any

import pytest

from sim.classroom.files.reading import Reading, Source
from sim.classroom.report.report import Asked, class_report
from sim.classroom.show.report_page import report_html
from tests.classroom.given.makers import answers, bank, keys, random_class, sources

BANK = bank(6)
ALL = {f"item-{k}": "ab"[k % 2] for k in range(6)}


def report(*files: dict[str, Any], key: str = keys(BANK), **asked: Any) -> dict[str, Any]:
    named = [Source(f"{k}.json", source.content) for k, source in enumerate(sources(files))]
    reading = Reading.of([*named, Source("key.json", key.encode())])
    return class_report(
        [(file, "class") for file in reading.files], reading.keys, reading.refused, Asked(**asked)
    )


def codes(made: dict[str, Any]) -> list[str]:
    return [flag["code"] for flag in made["flags"]]


def test_an_ordinary_class_raises_no_flag() -> None:
    made = report(*random_class(bank(12), 20), key=keys(bank(12)))
    assert codes(made) == []
    assert made["files"]["counted"] == 40


def test_every_flag_is_a_question() -> None:
    one = answers(BANK, "FOX", "pre", ALL)
    made = report(
        one,
        {**one, "student": "OWL"},
        answers(BANK, "FOX", "pre", {"item-0": "c"}, day=3),
        answers(BANK, "BEE", "pre", ALL, saved="2019-01-01T00:00:00Z"),
        answers(BANK, "CAT", "pre", ALL, site="another"),
        answers(BANK, "DOG", "pre", ALL, lessonHash="ffffffffffff"),
    )
    assert {"doubled-id", "equal-files", "impossible-times", "foreign-site", "other-version"} <= (
        set(codes(made))
    )
    for flag in made["flags"]:
        assert "?" in flag["sentence"] or "Ask before" in flag["sentence"]
        assert flag["files"]


def test_an_answer_that_the_page_told_to_be_right_and_the_key_does_not_is_asked_about() -> None:
    """The number was changed after the lesson, and not the words, of which the hash is."""
    told = answers(BANK, "FOX", "pre", ALL | {"item-0": "d"})  # the key says a
    for row in told["items"]:
        row |= {"tries": 1, "right": 1}
    asked = [flag["sentence"] for flag in report(told)["flags"] if flag["code"] == "told-right"]
    marked = {row["id"]: row["right"] for row in report(told)["lessons"][0]["forms"][0]["items"]}
    assert [one.partition(" (")[0] for one in asked] == [
        f"Question {k}" for k, right in enumerate(marked.values(), 1) if not right
    ]
    assert asked[0].startswith("Question 1 (")


def test_equal_files_are_counted_and_asked_about() -> None:
    made = report(answers(BANK, "FOX", "pre", ALL), answers(BANK, "OWL", "pre", ALL, start=5))
    (flag,) = made["flags"]
    assert flag["sentence"].startswith("Same answers in 2 files. Partners and good students do")
    assert "times" not in flag["sentence"]  # the one began five minutes later
    assert flag["files"] == ("0.json", "1.json")
    assert made["files"]["counted"] == 2


def test_a_copy_with_equal_times_is_asked_about_as_such() -> None:
    made = report(answers(BANK, "FOX", "pre", ALL), answers(BANK, "OWL", "pre", ALL))
    assert "times are equal as well" in made["flags"][0]["sentence"]


def test_the_same_file_twice_counts_once() -> None:
    one = answers(BANK, "FOX", "pre", ALL)
    made = report(one, one)
    assert codes(made) == ["same-file"]
    assert made["files"]["counted"] == 1
    assert made["files"]["set_aside"] == ["1.json"]


def test_of_two_saves_the_later_one_counts() -> None:
    early = answers(BANK, "FOX", "pre", {"item-0": "a"}, saved="2026-09-01T09:00:00Z")
    late = answers(BANK, "fox ", "pre", ALL, saved="2026-09-01T10:00:00Z")
    made = report(late, early)
    assert codes(made) == ["saved-again"]
    assert made["files"]["set_aside"] == ["1.json"]


def test_two_students_with_one_code_word_are_both_left_out() -> None:
    made = report(
        answers(BANK, "FOX", "pre", ALL, day=1),
        answers(BANK, "FOX", "pre", {"item-0": "b"}, day=2),
        answers(BANK, "OWL", "pre", {"item-0": "b"}),
    )
    assert codes(made) == ["doubled-id"]
    assert made["files"]["counted"] == 1
    assert "None of them is counted" in made["flags"][0]["sentence"]


def test_answers_to_another_wording_are_not_counted() -> None:
    other = answers(BANK, "FOX", "pre", ALL)
    for item in other["items"]:
        item["hash"] = "ffffffffffff"
    made = report(other, *[answers(BANK, f"OWL-{k}", "pre", {"item-0": "a"}) for k in range(5)])
    assert "foreign-version" in codes(made)
    form = made["lessons"][0]["forms"][0]
    assert form["groups"][0]["n"] == 5
    (student,) = [row for row in form["students"] if row["student"] == "FOX"]
    assert student["total"] is None
    assert len(student["foreign"]) == 6


def test_clocks_and_haste_are_asked_about() -> None:
    ahead = answers(BANK, "FOX", "pre", ALL)
    assert codes(report(ahead, now="2026-08-01T00:00:00Z")) == ["impossible-times"]
    fast = answers(BANK, "OWL", "pre", ALL)
    for item in fast["items"]:
        item["first"] = item["last"] = "2026-09-01T08:05:00.000Z"
    assert codes(report(fast)) == ["in-haste"]
    early = answers(BANK, "BEE", "post", ALL, day=1)
    late = answers(BANK, "BEE", "pre", ALL, day=2)
    assert codes(report(early, late)) == ["post-before-pre"]


@pytest.mark.parametrize(("now", "asked"), [("08-31T09:59", []), ("08-31T07:59", ["impossible"])])
def test_a_clock_may_be_ahead_by_a_day_and_no_more(now: str, asked: list[str]) -> None:
    """Saved on 1 September at 08:59."""
    found = codes(report(answers(BANK, "FOX", "pre", ALL), now=f"2026-{now}:00Z"))
    assert [code.partition("-")[0] for code in found] == asked


@pytest.mark.parametrize(("last", "asked"), [("09.900", ["in-haste"]), ("10.100", [])])
def test_two_seconds_from_each_answer_to_the_next_are_no_haste(last: str, asked: list[str]) -> None:
    """Six answers: five times two seconds."""
    fast = answers(BANK, "OWL", "pre", ALL)
    for item in fast["items"]:
        item["first"] = item["last"] = "2026-09-01T08:05:00.000Z"
    fast["items"][-1]["last"] = f"2026-09-01T08:05:{last}Z"
    assert codes(report(fast)) == asked


def test_of_questions_of_one_kind_the_first_are_asked_in_full_and_the_others_on_demand() -> None:
    late = [answers(BANK, f"OWL-{k}", "pre", ALL, saved="2019-01-01T00:00:00Z") for k in range(6)]
    made = report(*late)
    asked = [flag["sentence"] for flag in made["flags"] if flag["code"] == "impossible-times"]
    assert len(asked) == 6
    before, folded, after = report_html(made).partition("<details><summary>4 more like these")
    assert folded and [sentence in before for sentence in asked] == [True] * 2 + [False] * 4
    assert all(sentence in after for sentence in asked[2:])


def test_a_file_without_an_answer_is_counted_and_named() -> None:
    made = report(
        answers(BANK, "FOX", "pre", ALL),
        answers(BANK, "OWL", "pre", {}),
        answers(BANK, "BEE", "pre", {"item-0": ""}),
    )
    (flag,) = made["flags"]
    assert flag["code"] == "unanswered"
    assert flag["files"] == ("1.json", "2.json")
    assert "Nothing is answered in 2 files" in report_html(made)
    assert made["files"]["counted"] == 3


def test_a_zip_beside_its_files_does_not_fill_the_top_of_the_report_with_their_names() -> None:
    one = answers(BANK, "FOX", "pre", ALL)
    made = report(*[one] * 40)
    assert len(made["files"]["set_aside"]) == 39  # the document names them all
    assert "Set aside: <bdi>1.json</bdi>, " in report_html(made)
    assert "13.json" not in report_html(made)
