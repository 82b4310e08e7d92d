"""Wrong numbers that were typed: which of those that the author knows each one is."""

from __future__ import annotations

from typing import Any

from sim.classroom.files.keyed import read_key_file
from sim.classroom.files.reading import Reading
from sim.classroom.report.marked import mark_file
from sim.classroom.report.report import WHOLE, Asked, class_report
from sim.country.rows import Place, rows_of
from sim.country.schema import NAMES
from sim.lesson.bank import read_bank
from tests.classroom.given.makers import answers, keys, sources

BANK = read_bank({"title": "Near", "items": [
    {"id": "speed", "type": "number", "ask": "How fast?", "answer": "0.20 m/s",
     "tolerance": "0.01 m/s", "wrong": [
         {"value": "0.60 m/s", "tolerance": "0.05 m/s", "belief": "motion-needs-force"},
         {"value": "0.62 m/s", "tolerance": "0.05 m/s", "belief": "bigger-pushes-more"},
     ]},
]})  # fmt: skip


def file_of(value: float) -> dict[str, Any]:
    return answers(BANK, "FOX", "pre", {"speed": value})


def test_a_number_that_fits_two_known_wrong_ones_is_counted_for_the_one_it_was_marked_as() -> None:
    (read,) = Reading.of(sources([file_of(0.61)])).files
    (key, *_) = known = read_key_file(keys(BANK))
    marked = mark_file(read, WHOLE, key, {})
    mark = marked.answers["speed"].mark
    assert mark
    assert mark.beliefs == ("motion-needs-force",)
    report = class_report([(read, WHOLE)], known, (), Asked())
    choices = report["lessons"][0]["forms"][0]["items"][0]["choices"]
    assert [(c["label"], c["count"]) for c in choices] == [("0.6 m/s", 1), ("0.62 m/s", 0)]
    (row,) = rows_of(marked, Place(WHOLE, 1, "", 1), key)
    assert dict(zip(NAMES, row, strict=True))["chosen"] == "0.6 m/s"
