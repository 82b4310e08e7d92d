"""The report of a class: who counts, what is computed, what is refused, and how it is worded."""

from __future__ import annotations

import json
import re
from typing import Any

import numpy
import pytest
from scipy import stats

from sim.classroom.files.reading import Reading, Source
from sim.classroom.files.records import as_record, from_record
from sim.classroom.report.report import Asked, class_report
from sim.classroom.show.escaped import escape
from sim.classroom.show.report_page import report_html
from sim.lesson.bank import read_bank
from tests.classroom.given.makers import answers, bank, keys, random_class, sources

BANK = bank(10)


def made(
    *groups: tuple[str, list[dict[str, Any]]], source: Any = BANK, **asked: Any
) -> dict[str, Any]:
    reading = Reading.of([Source("key.json", keys(source).encode())])
    files = []
    for name, answer_files in groups:
        files += [(read, name) for read in Reading.of(sources(answer_files)).files]
    names = tuple(name for name, _ in groups)
    return class_report(files, reading.keys, [], Asked(groups=names, **asked))


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
    for lesson in report["lessons"]:
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


def test_topics_are_compared_before_and_after() -> None:
    source = bank(12, topics=("first-law", "third-law"))
    students = random_class(source, 12)
    rows = made(("class", students), source=source)["lessons"][0]["topics"]
    assert [(row["topic"], row["questions"], row["of"]) for row in rows] == [
        ("first-law", 6, 6), ("third-law", 6, 6),
    ]  # fmt: skip
    of_topic = [name for name, item in source.items.items() if "first-law" in item.common.topics]
    by_hand = [
        sum(i["value"] == source.items[i["id"]].key()["correct"][0]
            for i in f["items"] if i["id"] in of_topic)
        for f in students if f["form"] == "pre"
    ]  # fmt: skip
    assert rows[0]["pre"]["mean"] == pytest.approx(sum(by_hand) / 12, rel=1e-12)
    assert made(("class", random_class(BANK, 12)))["lessons"][0]["topics"] == []


def test_two_groups_are_compared_in_each_topic_as_in_a_test_of_its_questions_alone() -> None:
    """The paper's own question: an advantage on the first law, and none on the third."""
    source = bank(12, topics=("first-law", "third-law"))
    new = random_class(source, 25, seed=1, gain=0.4, prefix="FOX")
    usual = random_class(source, 22, seed=2, gain=0.1, prefix="OWL")
    rows = made(("new", new), ("usual", usual), source=source)["lessons"][0]["topic_differences"]
    assert [row["topic"] for row in rows] == ["first-law", "third-law"]
    assert all(row["groups"] == ["new", "usual"] for row in rows)

    def marks(students: list[dict[str, Any]], form: str) -> list[int]:
        return [
            sum(i["value"] == source.items[i["id"]].key()["correct"][0] for i in f["items"]
                if "third-law" in source.items[i["id"]].common.topics)
            for f in students if f["form"] == form
        ]  # fmt: skip

    before = [*marks(new, "pre"), *marks(usual, "pre")]
    after = [*marks(new, "post"), *marks(usual, "post")]
    design = [[1.0, float(k < 25), float(b)] for k, b in enumerate(before)]
    fitted, *_ = numpy.linalg.lstsq(numpy.array(design), numpy.array(after, float), rcond=None)
    assert rows[1]["difference"] == pytest.approx(fitted[1], rel=1e-9)
    assert rows[1]["low"] < rows[1]["difference"] < rows[1]["high"]
    assert "third-law" in rows[1]["sentence"]
    alone = made(("all", new), source=source)["lessons"][0]
    assert alone["topics"]
    assert alone["topic_differences"] == []


def two(**asked: Any) -> dict[str, Any]:
    one = random_class(BANK, 25, seed=1, gain=0.35, prefix="FOX")
    other = random_class(BANK, 22, seed=2, gain=0.1, prefix="OWL")
    return made(("new", one), ("usual", other), **asked)["lessons"][0]["comparison"]


def test_the_baseline_stands_before_any_claim() -> None:
    sentences = two()["sentences"]
    assert sentences[0].startswith("Before teaching: new minus usual")
    assert sentences[1].startswith("Adjusted for the start")


def test_groups_that_start_apart_are_said_to() -> None:
    one = random_class(BANK, 25, seed=1, prefix="FOX")
    low = random_class(bank(10), 25, seed=3, gain=0.5, prefix="OWL")
    for file in low:
        if file["form"] == "pre":
            file["items"] = file["items"][:3]
    comparison = made(("new", one), ("usual", low))["lessons"][0]["comparison"]
    assert abs(comparison["baseline"]["z"]) > 1
    assert "A group that starts low tends to rise by itself" in comparison["sentences"][0]


def test_with_one_class_in_each_group_no_p_is_told() -> None:
    one_class = two()
    assert not one_class["p_shown"]
    told = " ".join(one_class["sentences"])
    assert "30 students in one room are not 30 independent experiments" in told
    assert "p =" not in told
    assert "p <" not in told
    several = two(classes={"new": 2, "usual": 2})
    assert several["p_shown"]
    assert "This is not the chance that teaching worked" in " ".join(several["sentences"])


def test_the_interval_stands_before_p() -> None:
    for sentence in two(classes={"new": 2, "usual": 2})["sentences"]:
        p = re.search(r"p [=<]", sentence)
        if p:
            assert 0 <= sentence.find("would fit") < p.start()


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
