"""A file without a code word is a person of its own, also where another has the same name."""

from __future__ import annotations

import json
from typing import Any

from sim.classroom.files.reading import Reading, Source
from sim.classroom.files.records import as_record
from sim.classroom.report.report import Asked, class_report
from tests.classroom.given.makers import answers, bank, keys
from tests.web.scene.given.widget_site import in_node

BANK = bank(6)


def source(name: str, right: int, form: str = "pre", day: int = 1, student: str = "") -> Source:
    values = {f"item-{k}": "abcd"[k % 4] if k < right else "x" for k in range(6)}
    made = answers(BANK, student, form, values, day=day)
    return Source(name, json.dumps(made).encode())


def report(*files: Source) -> dict[str, Any]:
    reading = Reading.of([Source("key.json", keys(BANK).encode()), *files])
    return class_report([(r, "class") for r in reading.files], reading.keys, [], Asked())


def test_two_files_of_one_name_without_code_words_are_two_persons() -> None:
    found = report(source("a.json", 2), source("a.json", 4, day=2), source("a.json", 6, "post"))
    assert found["files"]["set_aside"] == []
    assert [flag["code"] for flag in found["flags"]] == ["no-code"]
    assert found["flags"][0]["files"] == ("a.json", "a (2).json", "a.json")
    assert len(found["lessons"][0]["forms"][0]["students"]) == 2


def test_the_same_file_twice_stays_one_and_a_code_word_needs_no_number() -> None:
    found = report(source("a.json", 2), source("a.json", 2))
    assert found["files"]["counted"] == 1
    assert "same-file" in {flag["code"] for flag in found["flags"]}
    named = report(source("a.json", 2, student="FOX"), source("a.json", 2, day=2, student="OWL"))
    assert {row["file"] for row in named["lessons"][0]["forms"][0]["students"]} == {"a.json"}


NAMES = ["a.json", "a.json", "a.json", "a (2).json", "b.c.json", "b.c.json", "d", "d", ".e", ".e"]
TOLD = ["a.json", "a (2).json", "a.json", "a (2) (2).json", "b.c.json", "b.c (2).json", "d",
        "d (2)", ".e", ".e (2)"]  # fmt: skip
DAYS = [1, 2, 1, 3, 1, 2, 1, 2, 1, 2]


def test_page_and_command_number_names_alike() -> None:
    files = [source(name, 1, day=day) for name, day in zip(NAMES, DAYS, strict=True)]
    assert [read.name for read in Reading.of(files).files] == TOLD
    rows = [as_record(read) for one in files for read in Reading.of([one]).files]
    taken = in_node(
        """globalThis.document = { documentElement: { dataset: {}, lang: "en" },
          getElementById: () => null };
        const { Classroom } = await import(source + "/class/classroom.js");
        const classroom = new Classroom();
        data.forEach((row, k) => classroom.take(
          { records: [row], keys: [], marks: [], refused: [], next: null }, k % 2));
        give(classroom.files.map((file) => file.row[0]));""",
        rows,
    )
    assert taken == TOLD


def test_what_was_deleted_leaves_no_number_behind() -> None:
    rows = [as_record(read) for day in (1, 2)
            for read in Reading.of([source("a.json", 1, day=day)]).files]  # fmt: skip
    taken = in_node(
        """globalThis.document = { documentElement: { dataset: {}, lang: "en" },
          getElementById: () => null };
        const { Classroom } = await import(source + "/class/classroom.js");
        const classroom = new Classroom();
        const take = (row) => classroom.take(
          { records: [row], keys: [], marks: [], refused: [], next: null }, 0);
        take(data[0]);
        Object.assign(classroom, new Classroom()); // as the page forgets everything
        take(data[1]);
        give(classroom.files.map((file) => file.row[0]));""",
        rows,
    )
    assert taken == ["a.json"]
