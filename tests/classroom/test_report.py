"""The report of a class: who counts, what is computed, what is refused, and how it is worded."""

from __future__ import annotations

import json

import pytest
from scipy import stats

from sim.classroom.files.reading import Reading, Source
from sim.classroom.files.records import as_record, from_record
from sim.classroom.report.report import Asked, class_report
from sim.classroom.show.escaped import escape
from sim.classroom.show.report_page import report_html
from sim.lesson.bank import read_bank
from tests.classroom.given.class_reports import BANK, made
from tests.classroom.given.makers import answers, bank, keys, random_class, sources


def test_totals_are_those_counted_by_hand() -> None:
    students = random_class(BANK, 12)
    report = made(("class", students))
    for table in report["lessons"][0]["forms"]:
        by_hand = {
            f["student"]: sum(
                i["value"] == BANK.items[i["id"]].key()["correct"][0] for i in f["items"]
            )
            for f in students
            if f["form"] == table["form"]
        }
        assert {row["student"]: row["total"] for row in table["students"]} == by_hand
        assert table["of"] == 10


def test_open_answers_are_listed_by_student_and_by_item() -> None:
    report = made(("class", [answers(BANK, "FOX", "pre", {"item-3": "a"})]))
    table = report["lessons"][0]["forms"][0]
    assert table["students"][0]["open"] == [f"item-{k}" for k in range(10) if k != 3]
    assert [row["empty"] for row in table["items"]] == [1, 1, 1, 0, 1, 1, 1, 1, 1, 1]


def test_distractors_are_counted_with_their_beliefs() -> None:
    files = [answers(BANK, f"FOX-{k}", "pre", {"item-0": "b" if k < 4 else "a"}) for k in range(6)]
    item = made(("class", files))["lessons"][0]["forms"][0]["items"][0]
    counts = {choice["option"]: choice["count"] for choice in item["choices"]}
    assert counts == {"a": 2, "b": 4, "c": 0, "d": 0}
    assert item["choices"][1]["says"] == "The one that moves or acts pushes harder."
    assert "students who choose it often think" in item["sentence"]
    assert "%" not in item["sentence"]  # fewer than ten students: counts


def test_a_belief_is_named_from_two_items_on() -> None:
    once = [answers(BANK, "FOX", "pre", {"item-0": "b"})]
    twice = [answers(BANK, "OWL", "pre", {"item-0": "b", "item-2": "b"})]
    assert made(("class", once))["lessons"][0]["forms"][0]["beliefs"] == []
    (row,) = made(("class", twice))["lessons"][0]["forms"][0]["beliefs"]
    assert (row["belief"], row["students"], row["sure"]) == ("mover-pushes-more", 1, 1)


@pytest.mark.parametrize("count", [0, 1, 2, 4])
def test_small_classes_get_no_statistics(count: int) -> None:
    report = made(("class", random_class(BANK, count)))
    assert len(report["lessons"]) == (count > 0)
    for lesson in report["lessons"]:
        assert (len(lesson["forms"]), len(lesson["gains"])) == (2, 1)
        assert all("mean" not in group for table in lesson["forms"] for group in table["groups"])
        assert all("gain" not in gain for gain in lesson["gains"])
        assert all("no statistics" in gain["sentences"][0] for gain in lesson["gains"])
    json.dumps(report, allow_nan=False)


def test_a_class_where_all_are_equal_is_refused_in_words() -> None:
    values = {f"item-{k}": "a" for k in range(10)}
    files = [
        answers(BANK, f"FOX-{k}", name, values, day=day, start=k)
        for k in range(8)
        for name, day in (("pre", 1), ("post", 9))
    ]
    report = made(("class", files))
    gain = report["lessons"][0]["gains"][0]
    assert gain["gain"] == 0
    assert gain["change"] is None
    assert gain["d"] is None
    assert any("no spread" in reason for reason in gain["refusals"])


def test_pairs_are_made_by_pseudonym_and_who_is_missing_is_listed() -> None:
    files = random_class(BANK, 8)
    report = made(("class", [f for f in files if (f["student"], f["form"]) != ("FOX-3", "post")]))
    gain = report["lessons"][0]["gains"][0]
    assert gain["n"] == 7
    assert gain["without_after"] == ["FOX-3"]
    assert "FOX-3" not in gain["students"]


def test_where_the_two_tests_have_other_marks_the_report_says_why_there_is_no_gain() -> None:
    forms = {"pre": BANK, "post": bank(8)}
    given = [Source(f"{name}.key", keys(of, [name]).encode()) for name, of in forms.items()]
    files = [f for name, of in forms.items() for f in random_class(of, 8) if f["form"] == name]
    reading = Reading.of([*given, *sources(files)])
    report = class_report([(read, "class") for read in reading.files], reading.keys, [], Asked())
    assert report["lessons"][0]["gains"] == []
    note = "The test before has 10 marks and the test after 8: no gain is computed."
    assert report["notes"][0] == note
    assert note in report_html(report)


def test_the_numbers_of_a_gain_are_those_of_scipy() -> None:
    gain = made(("class", random_class(BANK, 30)))["lessons"][0]["gains"][0]
    theirs = stats.ttest_rel(gain["after"], gain["before"])
    assert gain["change"]["p"] == pytest.approx(theirs.pvalue, rel=1e-12)
    before, after = sum(gain["before"]) / 30, sum(gain["after"]) / 30
    assert gain["gain"] == pytest.approx((after - before) / (10 - before), rel=1e-12)


def test_no_sentence_of_a_report_is_cut_on_its_page() -> None:
    one = random_class(BANK, 25, seed=1, gain=0.12, prefix="FOX")
    other = random_class(BANK, 22, seed=2, gain=0.1, prefix="OWL")
    report = made(("new", one), ("usual", other), classes={"new": 2, "usual": 2})
    page = report_html(report)
    assert "…" not in page
    for sentence in report["lessons"][0]["comparison"]["sentences"]:
        assert escape(sentence.strip()) in page


def test_without_scipy_there_are_means_and_gains_and_no_tests() -> None:
    report = made(("class", random_class(BANK, 20)), inference=False)
    lesson = report["lessons"][0]
    assert lesson["forms"][0]["groups"][0]["mean"] > 0
    assert lesson["gains"][0]["gain"] is not None
    assert "change" not in lesson["gains"][0]


def test_texts_are_read_and_marked_by_the_teacher() -> None:
    source = bank(3, words=1)
    files = random_class(source, 6)
    before = made(("class", files), source=source)["lessons"][0]["forms"][0]
    assert before["of"] == 3
    assert before["unread"] == ["why-0"]
    assert len(before["words"][0]["answers"]) >= 5
    given = {("carts", "pre", row["student"], "why-0"): 2 for row in before["students"]}
    after = made(("class", files), source=source, given=given)["lessons"][0]["forms"][0]
    assert after["of"] == 5
    assert after["unread"] == []
    assert [a["marks"] for a in after["words"][0]["answers"]] == [2] * len(
        after["words"][0]["answers"]
    )


def test_a_record_comes_back_as_the_file_it_was() -> None:
    for read in Reading.of(sources(random_class(bank(4, words=1), 3))).files:
        assert from_record(json.loads(json.dumps(as_record(read)))) == read


def test_hostile_names_stay_text() -> None:
    name = "<img src=x onerror=alert(1)>\u202e=1+1"
    report = made(("class", [answers(BANK, name, "pre", {"item-0": "a"})]))
    assert report["lessons"][0]["forms"][0]["students"][0]["student"] == name
    json.dumps(report, allow_nan=False)


def test_an_answer_that_is_a_picture_or_a_formula_is_talked_about_in_its_words() -> None:
    options = [
        {"text": "equal", "correct": True},
        {"text": r"\(\frac{F}{m}\) ![the long arrow](a.png)"},
    ]
    source = read_bank({"title": "Made up", "items": [
        {"id": "which", "type": "single", "ask": "Which?", "options": options},
    ]})  # fmt: skip
    files = [answers(source, f"FOX-{k}", "pre", {"which": "b"}, start=k) for k in range(3)]
    (form,) = made(("class", files), source=source)["lessons"][0]["forms"]
    (talk,) = form["talk"]
    assert "3 of 3 chose B (“F/m the long arrow”)" in talk["sentence"]
