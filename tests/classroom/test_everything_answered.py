"""What students answered reaches the teacher: predictions, reasons, certainty, wrong numbers."""

from __future__ import annotations

import csv
import io
import json
from typing import Any

from sim.classroom.files.reading import Reading, Source
from sim.classroom.report.items.typed_numbers import typed_sentence
from sim.classroom.report.report import Asked, class_report
from sim.classroom.report.settings import told_settings
from sim.classroom.show.class_csv import items_csv
from sim.classroom.show.report_page import report_html
from sim.cli.classroom.text import report_as_text
from sim.lesson.bank import Bank, read_bank
from tests.classroom.given.makers import answers, bank, keys, random_class, sources
from tests.classroom.given.page_report import report_of

TIME = "2026-09-01T08:00:00.000Z"


def prediction(kind: str, value: Any, said: str, **more: str) -> dict[str, Any]:
    return {"id": f"scene-{kind}", "hash": "", "type": kind, "value": value, "first": TIME,
            "last": TIME, "tries": 1, "said": said, "asked": f"What, {kind}?", **more}  # fmt: skip


def worksheet(student: str, items: list[dict[str, Any]]) -> dict[str, Any]:
    return answers(bank(1), student, "worksheet", {}) | {"items": items}


CLASS = [
    worksheet(f"FOX-{k}", [
        prediction("choice", "0", "the same on both", locked=TIME, why="they touch", sure="sure"),
        prediction("arrows", [{"pair": "A-B", "on": "A", "size": 2.0}], "force on A by B: 2.0 N"),
        prediction("curve", [0, 2, k, 2, 0], f"heights 0, 2, {k}, 2, 0", locked=TIME),
    ])
    for k in range(3)
] + [
    worksheet("OWL-1", [prediction("choice", "1", "more on B · Why: light", locked=TIME)]),
]  # fmt: skip


def test_predictions_are_counted_with_their_reasons_and_curves_are_kept() -> None:
    report = report_of(CLASS)
    (form,) = report["lessons"][0]["forms"]
    rows = {row["type"]: row for row in form["predictions"]}
    assert rows["choice"]["answers"] == [
        {"said": "the same on both", "count": 3, "sure": 3},
        {"said": "more on B", "count": 1, "sure": 0},
    ]
    assert [row["why"] for row in rows["choice"]["reasons"]] == ["they touch"] * 3
    assert rows["arrows"]["n"] == 3
    assert rows["arrows"]["locked"] == 0
    assert rows["curve"]["curves"] == [[0, 2, k, 2, 0] for k in range(3)]
    html, text = report_html(report), report_as_text(report, {})
    assert html.count('class="drawn"') == 3
    assert "What, choice?" in html
    assert "3 × the same on both" in text


def test_who_had_seen_the_run_has_not_predicted_it() -> None:
    again = prediction("choice", "1", "more on B", locked=TIME, again=TIME, why="I saw it")
    report = report_of([*CLASS, worksheet("OWL-2", [again])])
    (form,) = report["lessons"][0]["forms"]
    (row,) = [row for row in form["predictions"] if row["type"] == "choice"]
    assert (row["n"], row["again"], row["locked"]) == (4, 1, 4)
    assert [one["count"] for one in row["answers"]] == [3, 1]
    assert row["reasons"][-1]["why"] == "I saw it"  # a reason is one, whenever it was found
    told = "1 was made again by a student who had seen the run; it is not counted."
    assert f"4 predictions. {told}" in report_html(report)
    assert told in report_as_text(report, {})
    (alone,) = report_of([worksheet("OWL-2", [again])])["lessons"][0]["forms"][0]["predictions"]
    assert (alone["n"], alone["again"], alone["answers"]) == (0, 1, [])


def test_what_a_student_typed_as_a_reason_is_text_and_no_markup() -> None:
    bad = prediction("choice", "<b>", "<img src=x>", why="<script>alert(1)</script>", asked="<i>")
    html = report_html(report_of([worksheet("FOX", [bad])]))
    assert "<script" not in html
    assert "<img" not in html


def test_files_without_a_code_word_are_persons_of_their_own() -> None:
    files = [worksheet("", [prediction("choice", str(k), f"answer {k}")]) for k in range(3)]
    found = sources(files)
    named = [Source(f"{k}-{one.name}", one.content) for k, one in enumerate(found)]
    reading = Reading.of(named)
    report = class_report([(one, "class") for one in reading.files], [], [], Asked())
    assert report["files"]["counted"] == 3
    assert [flag["code"] for flag in report["flags"]] == ["no-code"]
    who = [row["student"] for row in report["lessons"][0]["forms"][0]["students"]]
    assert len(set(who)) == 3
    assert all("no code word" in name for name in who)


def test_a_file_without_a_code_word_can_be_given_one() -> None:
    before = answers(bank(1), "FOX", "pre", {"item-0": "a"})
    after = answers(bank(1), "", "post", {"item-0": "a"}, day=20)
    reading = Reading.of(
        [*sources([before]), Source("folder/lost.json", json.dumps(after).encode())]
    )
    reading.name({"lost.json": "fox"})
    (key,) = [Reading.of([Source("k", keys(bank(1)).encode())]).keys]
    report = class_report([(one, "class") for one in reading.files], key, [], Asked())
    assert report["lessons"][0]["gains"][0]["n"] == 1


NUMBERS = read_bank({"title": "Numbers", "items": [{
    "id": "speed", "type": "number", "ask": "How fast?", "answer": "0.30 m/s", "tolerance": "1 %",
    "wrong": [{"value": "0.60 m/s", "belief": "motion-needs-force", "feedback": "Before."}],
    "sure": True,
}]})  # fmt: skip


def test_a_known_wrong_number_is_counted_with_its_belief_and_talked_about_first() -> None:
    values = [0.3, 0.6, 0.6, 0.6, 0.9]
    files = [answers(NUMBERS, f"FOX-{k}", "pre", {"speed": v}) for k, v in enumerate(values)]
    report = report_of(files, keys(NUMBERS, ("pre",)))
    (form,) = report["lessons"][0]["forms"]
    (item,) = form["items"]
    (wrong,) = item["choices"]
    assert (wrong["label"], wrong["count"], wrong["sure"]) == ("0.6 m/s", 3, 3)
    assert wrong["says"]
    assert item["sure"] == {"right": 1, "wrong": 4}
    (talk,) = form["talk"]
    assert talk["sentence"].startswith("Question 1: 3 of 5 chose 0.6 m/s, 3 of them sure; students")


def in_two_ways(*names: str) -> Bank:
    """Single choices with two wrong answers of one belief, and one of another."""
    options = [
        {"text": "equal", "correct": True},
        {"text": "the heavy one", "belief": "bigger-pushes-more"},
        {"text": "the fast one", "belief": "mover-pushes-more"},
        {"text": "the big one", "belief": "bigger-pushes-more"},
    ]
    asked = {"type": "single", "ask": "Which?", "options": options}
    return read_bank({"title": "Two ways", "items": [{"id": name, **asked} for name in names]})


def test_a_belief_is_talked_about_once_with_all_answers_that_go_with_it() -> None:
    """In the first question two chose “the heavy one” and two “the big one”: together more than
    the three of “the fast one”."""
    ways = in_two_ways("first", "second", "third")
    chosen = [("b", "b"), ("b", "b"), ("d", "a"), ("d", "a"), ("c", "a"), ("c", "a"), ("c", "a")]
    files = [
        answers(ways, f"FOX-{k}", "pre", {"first": one, "second": other, "third": other})
        for k, (one, other) in enumerate(chosen)
    ]
    (form,) = report_of(files, keys(ways, ("pre",)))["lessons"][0]["forms"]
    (talk,) = form["talk"]
    assert talk["id"] == "first"
    said = talk["sentence"]
    assert said.startswith("Question 1: 4 of 7 chose B (“the heavy one”) or D (“the big one”)")
    assert said.count("often think") == 1
    assert said.endswith("Also in: Question 2, Question 3.")


def test_a_question_that_nobody_had_right_is_talked_about_without_a_shared_wrong_answer() -> None:
    files = [
        answers(NUMBERS, f"FOX-{k}", "pre", {"speed": v}) for k, v in enumerate([0.9, 1.5, 7.0])
    ]
    (form,) = report_of(files, keys(NUMBERS, ("pre",)))["lessons"][0]["forms"]
    (talk,) = form["talk"]
    assert talk["sentence"] == "Question 1: none of 3 who answered had it right."


def test_a_question_that_nobody_answered_is_talked_about() -> None:
    two = in_two_ways("first", "second")
    files = [answers(two, f"FOX-{k}", "pre", {"first": "a"}) for k in range(4)]
    (form,) = report_of(files, keys(two, ("pre",)))["lessons"][0]["forms"]
    (talk,) = form["talk"]
    assert talk["sentence"] == "Question 2: none of 4 students answered it."


def test_questions_that_nobody_came_to_stand_last_and_together() -> None:
    source = bank(4)
    files = [answers(source, f"FOX-{k}", "pre", {"item-0": "b"}) for k in range(5)]
    (form,) = report_of(files, keys(source, ("pre",)))["lessons"][0]["forms"]
    shared, nobody = form["talk"]
    assert shared["sentence"].startswith("Question 1: 5 of 5 chose")
    assert nobody["sentence"] == (
        "Question 2, Question 3, Question 4: none of 5 students answered any of them."
    )


def test_other_wrong_numbers_are_told_when_they_came_often() -> None:
    values = [0.3, 0.9, 0.9, 0.6, 0.6, 1.5, 1.5, 1.5, 7]
    files = [answers(NUMBERS, f"FOX-{k}", "pre", {"speed": v}) for k, v in enumerate(values)]
    (form,) = report_of(files, keys(NUMBERS, ("pre",)))["lessons"][0]["forms"]
    (item,) = form["items"]
    assert [(one["label"], one["count"]) for one in item["typed"]] == [
        ("1.5 m/s", 3),
        ("0.9 m/s", 2),
    ]
    assert typed_sentence(item) == "Other wrong numbers: 1.5 m/s (3 times) and 0.9 m/s (2 times)."


def test_questions_are_called_what_students_call_them() -> None:
    source = bank(3)
    report = report_of(random_class(source, 6), keys(source))
    form = report["lessons"][0]["forms"][0]
    assert [item["label"] for item in form["items"]] == [f"Question {k}" for k in (1, 2, 3)]
    assert len(form["talk"]) <= 3


def test_who_left_a_question_open_is_not_among_those_who_answered_it() -> None:
    source = bank(2)
    files = [
        answers(source, f"FOX-{k}", "pre", {"item-0": "a" if k else "", "item-1": "b"})
        for k in range(6)
    ]
    report = report_of(files, keys(source, ("pre",)))
    row = next(csv.DictReader(io.StringIO(items_csv(report).removeprefix("\ufeff"))))
    assert (row["answered by"], row["open"]) == ("5", "1")
    assert "partly" in row and "partly" in report_as_text(report, {})


def challenge(student: str, runs: int, found: int, values: str = "") -> dict[str, Any]:
    row = prediction("x", {"runs": runs, "found": found, "values": values}, "")
    return worksheet(student, [row | {"id": "break", "type": "challenge", "asked": "Twice?"}])


def test_settings_are_told_with_the_unit_of_each_number() -> None:
    told = told_settings({
        "B.velocity": -0.5, "A.mass": "0.2 kg", "friction.coefficient": 0.02, "until": 3,
        "push.force": 1.5, "contact.restitution": 0.5, "contact.law": "bumper", "drag.active": True,
    })  # fmt: skip
    assert told == (
        "A.mass 0.2 kg, B.velocity -0.5 m/s, contact.law bumper, contact.restitution 0.5, "
        "drag.active True, friction.coefficient 0.02, push.force 1.5 N, until 3 s"
    )


def test_what_students_tried_with_runs_of_their_own_is_told() -> None:
    reading = prediction("x", -0.26, "-0.26 m/s", asked="Which velocity?") | {
        "id": "read", "type": "reading", "own": -0.264, "set": {"A.mass": 2, "A.skin": ["no"]},
    }  # fmt: skip
    force = prediction("x", "2.4", "mean force on A by B: −2.4 N", asked="Find a force")
    files = [
        challenge("FOX-1", 12, 0),
        challenge("FOX-2", 1, 0),
        challenge("FOX-3", 4, 3, "mass of A 1 kg"),
        worksheet("OWL-1", [reading, force | {"id": "two-forces", "type": "found-force"}]),
        worksheet("OWL-2", [{**reading, "set": {}}]),
    ]
    report = report_of(files)
    (form,) = report["lessons"][0]["forms"]
    rows = {row["kind"]: row for row in form["own_runs"]}
    tried = rows["challenge"]
    assert (tried["n"], tried["runs"], tried["found"]) == (3, 17, 1)
    assert tried["said"] == [{"said": "mass of A 1 kg", "count": 1}]
    assert rows["reading"]["said"] == [
        {"said": "A.mass 2 kg", "count": 1}
    ]  # who changed nothing: not
    assert rows["found-force"]["said"][0]["said"].startswith("mean force on A")
    assert [item["id"] for item in form["items"]] == ["read"]  # the others are no questions
    html, text = report_html(report), report_as_text(report, {})
    assert "3 students tried 17 runs; 1 found one." in html
    assert "3 students tried 17 runs; 1 found one." in text
    nobody = report_html(report_of(files[:2]))
    assert "2 students tried 13 runs; nobody found one." in nobody
