"""Numbers that are read off a student's own run: marked by that run, or by a person without it."""

from __future__ import annotations

import json
from typing import Any

from sim.classroom.files.keyed import read_key_file
from sim.classroom.files.reading import Reading
from sim.classroom.handouts.paper import Handout, handout
from sim.classroom.report.report import Asked, class_report
from sim.lesson.key_file import key_file
from sim.lesson.read import read_question
from tests.classroom.given.makers import answers, bank, sources

OWN = 0.2  # m/s, in the run of each student
SPEED = read_question(
    {"id": "speed", "type": "reading", "ask": "How fast?", "scene": "bump", "quantity": "v.A",
     "tolerance": "5 %"}
)  # fmt: skip
OTHER = bank(1)


def files(told: int) -> list[dict[str, Any]]:
    """Three worksheets, both questions right; `told` of them tell the run."""
    made = []
    for k in range(3):
        file = answers(OTHER, f"FOX-{k}", "worksheet", {"item-0": "a"})
        row = {**file["items"][0], "id": SPEED.id, "hash": SPEED.hash, "type": "reading",
               "value": 0.2}  # fmt: skip
        file["items"].append(row | ({"own": OWN} if k < told else {}))
        made.append(file)
    return made


def report(told: int, **asked: Any) -> dict[str, Any]:
    key = read_key_file(json.dumps(key_file("tests", "carts", [SPEED, *OTHER.items.values()], [])))
    read = [(one, "class") for one in Reading.of(sources(files(told))).files]
    (form,) = class_report(read, key, [], Asked(**asked))["lessons"][0]["forms"]
    return dict(form)


def test_a_reading_is_marked_by_the_run_that_its_file_tells() -> None:
    form = report(3)
    assert [row["total"] for row in form["students"]] == [2, 2, 2]
    assert form["words"] == []


def test_one_that_tells_no_run_is_read_by_the_teacher() -> None:
    before = report(2)
    (asked,) = before["words"]
    assert [row["text"] for row in asked["answers"]] == ["0.2 m/s"]
    assert before["unread"] == ["speed"]
    given = {("carts", "worksheet", before["students"][2]["student"], "speed"): 0}
    after = report(2, given=given)
    assert after["unread"] == []
    assert [row["total"] for row in after["students"]] == [2, 2, 1]
    assert [row["marks"] for row in after["words"][0]["answers"]] == [0]  # to be changed again


def test_a_slip_with_right_answers_tells_what_the_students_own_run_says() -> None:
    key = read_key_file(json.dumps(key_file("tests", "carts", [SPEED], [])))
    (file, *_) = files(3)
    file["items"][-1]["value"] = 0.5
    read = [(one, "class") for one in Reading.of(sources([file])).files]
    slip = handout(read, key, Asked(), Handout(what="slips", words={}, answers=True))
    assert "You answered: 0.5 m/s" in slip and "Right: 0.2 m/s" in slip
