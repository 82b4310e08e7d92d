"""Files of answers: the damaged, the foreign and those from the future are refused, twice alike."""

from __future__ import annotations

import json
import random
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim.lesson.answer_file import PREDICTIONS, AnswerFileError, read_answer_file
from sim.lesson.csv_text import csv_cell
from sim.lesson.read import KINDS
from tests.lesson.good_answers import GOOD, ITEM
from tests.web.scene.given.widget_site import in_node

CELLS = json.loads((Path(__file__).parent / "csv_cells.json").read_text(encoding="utf-8"))


def deep(levels: int) -> str:
    return "[" * levels + "]" * levels


def damaged() -> dict[str, str]:
    """Texts that must be refused, by what is wrong with them."""

    def file(**changes: Any) -> str:
        return json.dumps({**GOOD, **changes})

    def item(**changes: Any) -> str:
        return file(items=[{**ITEM, **changes}])

    cases = {
        "empty": "", "spaces": "   ", "no json": "hello", "a list": "[]", "a number": "3",
        "null": "null", "a text": '"text"', "html": "<html></html>", "xml": "<?xml version='1.0'?>",
        "nan": file().replace('"tries": 1', '"tries": NaN'),
        "deep": deep(100_000), "huge": " " * 10_000_000,
        "other kind": file(kind="newtons-carts-key"), "no kind": json.dumps({"format": 1}),
        "future": file(format=2), "far future": file(format=10**9), "format 0": file(format=0),
        "format text": file(format="1"), "format true": file(format=True),
        "format fraction": file(format=1.5), "no form": file(form="exam"),
        "form list": file(form=[]), "items table": file(items={}), "items text": file(items="x"),
        "item null": file(items=[None]),
        "item text": file(items=["x"]), "too many items": file(items=[ITEM] * 2001),
        "student number": file(student=5), "student newline": file(student="A\nB"),
        "student long": file(student="A" * 201), "student key": file(student="A#b"),
        "lesson null": file(lesson=None),
        "no id": item(id=None), "id path": item(id="../x"), "id proto": item(id="__proto__"),
        "id script": item(id="<script>"), "id long": item(id="a" * 81), "hash": item(hash="xyz"),
        "hash number": item(hash=1), "type": item(type="<b>"), "time": item(first="yesterday"),
        "time number": item(last=5), "tries": item(tries=-1), "tries text": item(tries="1"),
        "tries true": item(tries=True), "tries many": item(tries=1_000_001),
        "value long": item(value="x" * 20_001), "value vast": item(value=1e300),
        "value deep": item(value=[[[[["x"]]]]]), "value wide": item(value=list(range(201))),
        "value proto": file().replace('"because"', '{"__proto__": 1}'),
        "value key": item(value={"a b": 1}), "value infinite": file().replace('"because"', "1e999"),
    }  # fmt: skip
    text = file()
    cases |= {f"cut at {at}": text[:at] for at in range(0, len(text), 7)}
    return cases


DAMAGED = damaged()


def test_a_good_file_is_read() -> None:
    read = read_answer_file("\ufeff" + json.dumps(GOOD))
    assert (read.student, read.form, read.latest()["why"].value) == (
        "BLUE-FOX-27", "worksheet", "because",
    )  # fmt: skip


def test_two_lessons_with_a_number_sign_give_two_files_that_page_and_teacher_read() -> None:
    script = """const { makeFiles, readFile } = await import(source + "/answers/file.js");
    const entry = { id: "why", hash: "", type: "free", value: "so", first: null, last: null,
      tries: 1 };
    const keys = ["worksheets/Sto\u00df #1#why", "worksheets/Sto\u00df #2#why", "a@b#quiz:why"];
    const files = makeFiles(keys.map((key) => [key, entry]), { site: "tests", student: "" },
      "2026-11-21T09:00:00.000Z");
    const texts = files.map((file) => JSON.stringify(file.content));
    give([texts, texts.map((text) => readFile(text, "tests"))]);"""
    texts, read = in_node(script, None)
    assert [read_answer_file(text).lesson for text in texts] == ["Stoß #1", "Stoß #2", "a@b"]
    assert [one["entries"][0][0] for one in read] == [
        "worksheets/Stoß #1#why", "worksheets/Stoß #2#why", "a@b#why",
    ]  # fmt: skip


def test_files_of_two_students_without_a_code_word_lie_side_by_side_in_a_folder() -> None:
    """Both were called “no-code”: on the stick that goes round the second took the place of the
    first. Who saves once more has the same name."""
    script = """const { makeFiles } = await import(source + "/answers/file.js");
    const name = (first, student, now) => makeFiles([["p#why", { id: "why", hash: "", type: "free",
      value: "so", first, last: first, tries: 1 }]], { site: "tests", student }, now)[0].name;
    give([name("2026-11-21T09:00:00.250Z", "", "2026-11-21T09:30:00.000Z"),
      name("2026-11-21T09:00:00.250Z", "", "2026-11-22T10:00:00.000Z"),
      name("2026-11-21T09:00:04.000Z", "", "2026-11-21T09:30:00.000Z"),
      name("2026-11-21T09:00:04.000Z", "BLUE-FOX-27", "2026-11-21T09:30:00.000Z")]);"""
    first, again, other, coded = in_node(script, None)
    assert first == again == "p.worksheet.no-code-1121-090000.carts.json"
    assert other == "p.worksheet.no-code-1121-090004.carts.json"
    assert coded == "p.worksheet.BLUE-FOX-27.carts.json"


def test_damaged_files_are_refused_in_words() -> None:
    for what, text in DAMAGED.items():
        with pytest.raises(AnswerFileError) as refused:
            read_answer_file(text)
        assert len(str(refused.value)) > 20, what


def test_the_page_refuses_the_same_files_and_reads_the_good_one() -> None:
    script = """const { readFile } = await import(source + "/answers/file.js");
    give(data.map((text) => readFile(text, "tests")));"""
    many = {what: text for what, text in DAMAGED.items() if what not in ("huge", "deep")}
    many |= {
        "page": json.dumps({**GOOD, "page": "@RED-OWL-1/a"}),
        "site": json.dumps({**GOOD, "site": "x"}),
    }
    many["deep"] = deep(5000)
    read = in_node(script, [*many.values(), json.dumps(GOOD)])
    for what, found in zip(many, read, strict=False):
        assert "problem" in found, what
    assert read[-1]["student"] == "BLUE-FOX-27"
    assert read[-1]["entries"][0][0] == "worksheets/kinds#why"


@pytest.mark.parametrize(
    "kind", sorted({*KINDS, *PREDICTIONS, "found-force", "challenge", "law", "drawn"})
)
def test_whatever_a_page_keeps_can_be_read_again_by_both(kind: str) -> None:
    found = [['["A","B"]', "mean force on A by B: −2.4 N"]]
    text = json.dumps({**GOOD, "items": [{**ITEM, "hash": "", "type": kind, "found": found}]})
    assert read_answer_file(text).latest()["why"].type == kind
    script = """const { readFile } = await import(source + "/answers/file.js");
    give(readFile(data, "tests"));"""
    (_, entry) = in_node(script, text)["entries"][0]
    assert (entry["type"], entry["found"]) == (kind, found)


def test_the_longest_text_that_the_editor_of_laws_takes_is_read_again_by_both() -> None:
    longest = in_node('give((await import(source + "/law/editor.js")).LONGEST);', None)
    text = json.dumps({**GOOD, "items": [{**ITEM, "value": "x" * longest}]})
    assert len(str(read_answer_file(text).latest()["why"].value)) == longest
    script = """const { readFile } = await import(source + "/answers/file.js");
    give(readFile(data, "tests").entries[0][1].value.length);"""
    assert in_node(script, text) == longest


@pytest.mark.parametrize(
    ("extra", "taken"),
    [
        ({"own": True}, None), ({"own": 1e300}, None), ({"own": 2.5}, 2.5),
        ({"right": 2}, None), ({"right": True}, None), ({"right": 1}, 1),
    ],
)  # fmt: skip
def test_what_an_answer_has_beside_its_value_is_taken_by_both_or_by_neither(
    extra: dict[str, Any], taken: float | None
) -> None:
    (name,) = extra
    text = json.dumps({**GOOD, "items": [{**ITEM, **extra}]})
    assert getattr(read_answer_file(text).latest()["why"], name) == taken
    script = """const { readFile } = await import(source + "/answers/file.js");
    give(readFile(data, "tests"));"""
    assert in_node(script, text)["entries"][0][1].get(name) == taken


def test_a_byte_changed_anywhere_gives_answers_or_a_message_and_nothing_else() -> None:
    dice = random.Random(7)
    text = json.dumps(GOOD)
    for _ in range(2000):
        at = dice.randrange(len(text))
        changed = text[:at] + chr(dice.randrange(1, 0x300)) + text[at + dice.randrange(2) :]
        try:
            read_answer_file(changed)
        except AnswerFileError as refused:
            assert str(refused)


JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner),
    max_leaves=5,
)


@given(st.sampled_from([*GOOD, *ITEM]), JSON)
def test_any_value_in_any_place_gives_answers_or_a_message(key: str, value: Any) -> None:
    changed = {**GOOD, key: value} if key in GOOD else {**GOOD, "items": [{**ITEM, key: value}]}
    try:
        read = read_answer_file(json.dumps(changed))
    except AnswerFileError:
        return
    assert isinstance(read.student, str)


def test_a_cell_is_never_a_formula_and_numbers_stay_numbers() -> None:
    for case in CELLS:
        assert csv_cell(case["value"]) == case["cell"], case
    script = """const { csvCell } = await import(source + "/answers/csv.js");
    give(data.map(({ value }) => csvCell(value)));"""
    assert in_node(script, CELLS) == [case["cell"] for case in CELLS]


def test_each_sign_that_begins_a_formula_is_made_harmless_behind_each_mark_nobody_sees() -> None:
    marks = ["", "\u200b", "\u200f", "\u202a", "\u202e", "\u2060", "\u2069", "\ufeff", "'"]
    texts = [f"{mark}{sign}1" for mark in marks for sign in "=+-@|%＝＋－＠"]
    script = (
        'const { csvCell } = await import(source + "/answers/csv.js"); give(data.map(csvCell));'
    )
    found = list(map(csv_cell, texts))
    assert found == [f'"\'{text}"' for text in texts] == in_node(script, texts)


@given(st.text(max_size=20))
def test_no_text_makes_a_cell_that_begins_like_a_formula(text: str) -> None:
    inside = csv_cell(text)[1:-1]
    formula = ("=", "+", "-", "@", "\t", "\r", "\n", "|", "%")
    assert inside == "%" or not inside.startswith(formula)
    assert inside.replace('""', "").count('"') == 0
