"""A lesson changed while students answered it: one word on what counts, everywhere."""

from __future__ import annotations

from typing import Any

import pytest

from sim.classroom.files.keyed import read_key_file
from sim.classroom.files.reading import Reading
from sim.classroom.handouts.class_sheet import sheet_html
from sim.classroom.handouts.slip import slips
from sim.classroom.handouts.slip_page import slips_html
from sim.classroom.report.marked import Keys
from sim.classroom.report.report import Asked, class_report, sorted_files
from sim.classroom.show.html_parts import telling
from sim.classroom.show.report_page import report_html
from sim.lesson.bank import Bank, read_bank
from tests.classroom.given.makers import answers, bank, keys, random_class, sources

BANK = bank(6)
RIGHT = {f"item-{k}": "abcd"[k % 4] for k in range(6)}
CHANGED = ("item-0", "item-3")  # Questions 1 and 4


def of_another_text() -> dict[str, Any]:
    file = answers(BANK, "FOX", "pre", RIGHT)
    for item in file["items"]:
        if item["id"] in CHANGED:
            item["hash"] = "ffffffffffff"
    return file


def class_of(files: list[dict[str, Any]], *made: str) -> tuple[list[Any], list[Any]]:
    read = [(one, "class") for one in Reading.of(sources(files)).files]
    return read, [key for text in made for key in read_key_file(text)]


def a_class() -> list[dict[str, Any]]:
    return [of_another_text(), *(answers(BANK, f"OWL-{k}", "pre", RIGHT) for k in range(5))]


def its_report(files: list[dict[str, Any]], *made: str) -> dict[str, Any]:
    return class_report(*class_of(files, *made), (), Asked(groups=("class",)))


def test_answers_to_an_unchanged_question_are_counted_and_the_others_are_not() -> None:
    (form,) = its_report(a_class(), keys(BANK))["lessons"][0]["forms"]
    assert {row["id"]: row["n"] for row in form["items"]} == {
        name: 5 if name in CHANGED else 6 for name in RIGHT
    }
    totals = {row["student"]: row["total"] for row in form["students"]}
    assert totals == {"FOX": None} | {f"OWL-{k}": 6 for k in range(5)}


def test_the_teacher_hears_which_questions_and_what_to_do() -> None:
    flags = its_report(a_class(), keys(BANK))["flags"]
    (flag,) = [one for one in flags if one["code"] != "equal-files"]
    assert flag["code"] == "foreign-version"
    assert "than the key has: 1, 4. These answers are not counted" in flag["sentence"]
    assert "its other answers are counted" in flag["sentence"]
    assert "Add the key file of the other text too" in flag["sentence"]


def test_tables_slips_and_the_page_of_the_class_say_the_same() -> None:
    files = a_class()
    made, tell = its_report(files, keys(BANK)), telling({})
    assert "<td>1, 4</td>" in report_html(made)
    assert "1 student had another text of some questions: no total" in sheet_html(made, tell)
    read, its_keys = class_of(files, keys(BANK))
    known = Keys(its_keys)
    counted = sorted_files(read, known, Asked(groups=("class",))).counted
    made_slips = slips(counted, known, ("class",))
    (fox,) = [slip for slip in made_slips if slip.student == "FOX"]
    assert (fox.forms[0].right, fox.forms[0].foreign) == ((2, 3, 5, 6), (1, 4))
    assert fox.forms[0].open == ()
    html = slips_html([fox], tell)
    assert "so they are not marked: 1, 4" in html and "Right: 2, 3, 5, 6" in html
    assert "marks</p>" not in html  # no total of what cannot be compared
    assert "6 of 6 marks" in slips_html(made_slips[1:], tell)


def test_who_answered_another_text_took_both_tests_and_is_named_apart() -> None:
    """And who took one test only is named for that, whatever text it was."""
    other = [of_another_text(), {**of_another_text(), "student": "EMU"}]
    both = [answers(BANK, f"OWL-{k}", name, RIGHT) for k in range(5) for name in ("pre", "post")]
    after = [answers(BANK, name, "post", RIGHT) for name in ("FOX", "BEE")]
    made = its_report([*other, *both, *after], keys(BANK))
    (gain,) = made["lessons"][0]["gains"]
    assert gain["n"] == 5
    assert (gain["without_before"], gain["without_after"]) == (["BEE"], ["EMU"])
    assert gain["of_another_text"] == ["FOX"]
    html = report_html(made)
    assert "only after, so in no pair: BEE<" in html
    assert "answered another text, so in no pair: FOX<" in html


OF_TOTALS = ("discrimination", "point_biserial", "point_biserial_total", "discrimination_quarter",
             "curve")  # fmt: skip


def test_who_has_no_total_is_compared_with_none_and_counts_in_the_difficulty() -> None:
    whole = [file for file in random_class(BANK, 30) if file["form"] == "pre"]
    partly = [{**of_another_text(), "student": f"EMU-{k}"} for k in range(12)]
    (alone,) = its_report(whole, keys(BANK))["lessons"][0]["forms"]
    (form,) = its_report([*whole, *partly], keys(BANK))["lessons"][0]["forms"]
    for one, other in zip(form["items"], alone["items"], strict=True):
        assert {name: one[name] for name in OF_TOTALS} == {name: other[name] for name in OF_TOTALS}
        assert one["point_biserial"] is not None
        more = 0 if one["id"] in CHANGED else 12
        assert (one["n"], one["right"]) == (other["n"] + more, other["right"] + more)
        assert one["difficulty"] == pytest.approx(one["right"] / one["n"])


OLD = {"p": "How did it go?", "q": "Unchanged?", "gone": "Left out later?"}
NEW = {"p": "How did it go then?", "q": "Unchanged?", "new": "Asked later?"}


def asking(texts: dict[str, str]) -> Bank:
    options = [{"text": "x", "correct": True}, {"text": "y"}]
    return read_bank({"title": "Changed", "items": [
        {"id": name, "type": "single", "ask": ask, "options": options}
        for name, ask in texts.items()
    ]})  # fmt: skip


@pytest.mark.parametrize("first", [OLD, NEW], ids=["the old key first", "the new key first"])
def test_with_the_keys_of_both_texts_totals_are_of_the_questions_that_both_ask(
    first: dict[str, str],
) -> None:
    files = [
        answers(asking(texts), f"{name}-{k}", "pre", dict.fromkeys(texts, "a"))
        for name, texts in (("OWL", OLD), ("BEE", NEW))
        for k in range(3)
    ]
    second = NEW if first is OLD else OLD
    made = its_report(files, keys(asking(first)), keys(asking(second)))
    (form,) = made["lessons"][0]["forms"]
    assert "foreign-version" not in [flag["code"] for flag in made["flags"]]
    assert form["of"] == 2
    assert [row["total"] for row in form["students"]] == [2] * 6
