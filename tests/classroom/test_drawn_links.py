"""Interaction diagrams of a class: the report says which lines were invented, which left out."""

from __future__ import annotations

import json
from typing import Any

from sim.classroom.files.keyed import read_key_file
from sim.classroom.files.reading import Reading
from sim.classroom.report.report import Asked, class_report
from sim.lesson.key_file import key_file
from sim.lesson.read import read_question
from tests.classroom.given.makers import answers, bank, sources

BALL = read_question(
    {"id": "ball", "type": "interactions", "ask": "A ball rises.",
     "objects": ["player", "ball", "Earth"],
     "contact": [["player", "Earth"]], "distance": [["ball", "Earth"]],
     "wrong": [{"between": ["player", "ball"], "belief": "force-carried-along"},
               {"between": ["ball", "Earth"], "by": "contact", "feedback": "Do they?"}]}
)  # fmt: skip
OTHER = bank(1)
STANDS = {"between": ["player", "Earth"], "by": "contact"}
FALLS = {"between": ["ball", "Earth"], "by": "distance"}
CARRIED = {"between": ["player", "ball"], "by": "contact"}
PRESSED = {"between": ["ball", "Earth"], "by": "contact"}
DRAWN: list[list[dict[str, Any]]] = [
    [STANDS, FALLS], [STANDS, FALLS, CARRIED], [STANDS, CARRIED], [STANDS, CARRIED, PRESSED], []
]  # fmt: skip


def form() -> dict[str, Any]:
    made = []
    for k, links in enumerate(DRAWN):
        file = answers(OTHER, f"FOX-{k}", "worksheet", {"item-0": "a"})
        file["items"].append(
            file["items"][0]
            | {"id": BALL.id, "hash": BALL.hash, "type": "interactions", "value": links}
        )
        made.append(file)
    key = read_key_file(json.dumps(key_file("tests", "carts", [BALL, *OTHER.items.values()], [])))
    read = [(one, "class") for one in Reading.of(sources(made)).files]
    return dict(class_report(read, key, [], Asked())["lessons"][0]["forms"][0])


def test_invented_lines_are_counted_with_the_belief_behind_them_and_right_ones_left_out() -> None:
    item = next(row for row in form()["items"] if row["id"] == "ball")
    assert [(row["label"], row["count"], row["belief"]) for row in item["choices"]] == [
        ("a line: player and ball", 3, "force-carried-along"),
        ("ball and Earth touch", 1, ""),
        ("no line: player and Earth touch", 0, ""),
        ("no line: ball and Earth, without touching", 2, ""),
    ]


def test_the_line_that_most_invented_is_what_to_talk_about() -> None:
    (talk,) = [row["sentence"] for row in form()["talk"] if row["id"] == "ball"]
    assert "3 of 4 chose a line: player and ball" in talk
    assert "carried along" in talk
