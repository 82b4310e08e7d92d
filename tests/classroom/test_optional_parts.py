"""A part for who has time gives no marks and is never missing; lessons have their titles."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from sim.classroom.files.keyed import read_key_file
from sim.classroom.files.reading import Reading, Source
from sim.classroom.handouts.paper import Handout, handout
from sim.classroom.handouts.slip import slips
from sim.classroom.report.marked import Keys
from sim.classroom.report.report import WHOLE, Asked, class_report, sorted_files
from sim.classroom.show.report_page import report_html
from sim.pages.blocks.scene_block import Lesson
from sim.pages.question.key_page import lesson_key
from tests.classroom.given.makers import TIME, sources

QUESTION = """
```question
id: {}
type: single
ask: Which?
options: [wrong, {{text: "good", correct: true}}]
```
"""
LESSON = f"""# Newton's carts

## The problem
{QUESTION.format("must")}
## Magnets {{: .more data-minutes=7 }}

### One of them
{QUESTION.format("may")}
```question
id: why
type: long
ask: Why?
rubric: {{1: a reason, 0: none}}
```
## At the end
{QUESTION.format("again")}"""


def key_text() -> str:
    key = lesson_key(LESSON, Lesson(str(Path("carts.md"))), "carts", "tests")
    assert key is not None
    return json.dumps(key.content)


def answered(student: str, **values: str) -> dict[str, Any]:
    """Letters of options, by question; the right one is `b`."""
    (form,) = read_key_file(key_text())
    time = TIME.format(day=1, minute=0, second=0)
    rows = [
        {"id": name, "hash": form.items[name].hash, "type": form.items[name].question.KIND,
         "value": value,
         "first": time, "last": time, "tries": 1}
        for name, value in values.items()
    ]  # fmt: skip
    return {"format": 1, "kind": "newtons-carts-answers", "site": "tests", "lesson": "carts",
            "lessonHash": "", "student": student, "form": "worksheet", "created": time,
            "saved": time, "page": "worksheets/carts", "items": rows}  # fmt: skip


SHEET = Handout(what="sheet", words={})
CLASS = [
    answered("FOX-1", must="b", again="b"),
    answered("FOX-2", must="b", again="b", may="a"),
    answered("FOX-3", must="b", again="a", may="b"),
]


def test_an_optional_question_gives_no_marks_and_is_never_left_open() -> None:
    reading = Reading.of([*sources(CLASS), Source("key.json", key_text().encode())])
    files = [(one, WHOLE) for one in reading.files]
    report = class_report(files, reading.keys, [], Asked())
    (form,) = report["lessons"][0]["forms"]
    assert form["of"] == 2
    assert [row["open"] for row in form["students"]] == [[], [], []]
    assert [item.get("optional", False) for item in form["items"]] == [False, True, True, False]
    html = report_html(report)
    assert "1 of 2, optional" in html
    of_files = Keys(reading.keys)
    made = slips(sorted_files(files, of_files, Asked()).counted, of_files, (WHOLE,))
    told = {slip.student: slip.forms[0] for slip in made}
    assert (told["FOX-1"].marks, told["FOX-1"].of, told["FOX-1"].open) == (2, 2, ())
    assert told["FOX-3"].right == (1, 2)  # what was answered is told
    assert [look.number for look in told["FOX-2"].look] == [2]


def test_an_optional_answer_in_words_is_to_be_read_and_not_wrong() -> None:
    files = [*CLASS, answered("FOX-4", must="b", again="b", why="They are a pair.")]
    reading = Reading.of([*sources(files), Source("key.json", key_text().encode())])
    read = [(one, WHOLE) for one in reading.files]
    (form,) = (report := class_report(read, reading.keys, [], Asked()))["lessons"][0]["forms"]
    assert (form["of"], form["unread"], form["items"][2]["unread"]) == (2, [], 1)
    assert "1 to read" in report_html(report) and "0 of 1, optional" not in report_html(report)
    assert "To be read by you: 3" in handout(read, reading.keys, Asked(), SHEET)


def test_a_report_calls_a_lesson_as_its_key_does() -> None:
    reading = Reading.of([*sources(CLASS), Source("key.json", key_text().encode())])
    files = [(one, WHOLE) for one in reading.files]
    assert "<h2>Newton's carts</h2>" in report_html(
        class_report(files, reading.keys, [], Asked())
    ).replace("&#x27;", "'").replace("&#39;", "'")
    assert class_report(files, [], [], Asked())["lessons"][0]["title"] == "Carts"
