"""An answer that cannot be understood, as of a file that was changed by hand, is one student's."""

from __future__ import annotations

from typing import Any

from sim.classroom.files.reading import Reading, Source
from sim.classroom.handouts.slip import slips
from sim.classroom.report.marked import Keys
from sim.classroom.report.report import WHOLE, Asked, class_report, sorted_files
from tests.classroom.given.makers import answers, bank, keys, sources

BANK = bank(3, words=1)
RIGHT = {"item-0": "a", "item-1": "b", "item-2": "c"}


def read(files: list[dict[str, Any]], asked: Asked) -> tuple[dict[str, Any], list[Any]]:
    reading = Reading.of([*sources(files), Source("key.json", keys(BANK).encode())])
    assert not reading.refused
    mine = [(file, WHOLE) for file in reading.files]
    known = Keys(reading.keys)
    counted = sorted_files(mine, known, asked).counted
    return class_report(mine, reading.keys, [], asked), slips(counted, known, (WHOLE,))


def test_one_answer_in_words_that_is_no_text_keeps_nobodys_question_out_of_the_total() -> None:
    files = [
        answers(BANK, "FOX", "pre", {**RIGHT, "why-0": ["no", "text"]}),
        *(answers(BANK, f"OWL-{k}", "pre", {**RIGHT, "why-0": f"since {k}"}, start=5 * k)
          for k in range(5)),
    ]  # fmt: skip
    given = {("carts", "pre", f"OWL-{k}", "why-0"): 2 for k in range(5)}
    report, made = read(files, Asked(given=given))
    (form,) = report["lessons"][0]["forms"]
    assert (form["of"], form["unread"]) == (5, [])
    totals = {row["student"]: row["total"] for row in form["students"]}
    assert totals == {"FOX": 3} | {f"OWL-{k}": 5 for k in range(5)}
    (fox,) = [slip.forms[0] for slip in made if slip.student == "FOX"]
    assert [look.number for look in fox.look] == [4]
