"""Slips and the page of a class: what a student is told, and that no name stands on the page."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import pytest

from sim.classroom.files.keyed import read_key_file
from sim.classroom.files.reading import Reading
from sim.classroom.handouts.belief_map import belief_map
from sim.classroom.handouts.paper import Handout, handout, handout_file
from sim.classroom.handouts.slip import MOST_TOLD, FormSlip, Slip, slips
from sim.classroom.handouts.slip_page import slips_html
from sim.classroom.report.marked import Keys
from sim.classroom.report.report import WHOLE, Asked, class_report, sorted_files
from sim.classroom.show.html_parts import telling
from sim.classroom.show.prose import prose
from sim.lesson.bank import Bank, read_bank
from sim.lesson.beliefs import BELIEFS
from sim.pages.language import LANGUAGES, words
from tests.classroom.given.makers import answers, bank, keys, random_class, sources

BANK = bank(8, words=1)
BELIEF = "bigger-pushes-more"
RICH = read_bank({
    "title": "Rich",
    "items": [
        {"id": "first", "type": "idea", "ask": "Who is right?",
         "options": [{"text": "Ana", "belief": BELIEF}, {"text": "Ben"}]},
        {"id": "push", "type": "single", "ask": "Which *push* is **larger**?", "sure": True,
         "explain": "They are a pair.",
         "options": [{"text": "that on <A>", "belief": BELIEF, "feedback": "Look again."},
                     {"text": "neither", "correct": True}]},
        {"id": "speed", "type": "number", "ask": r"What is \(\Delta v\)?", "answer": "-0.25 m/s",
         "tolerance": "0.01 m/s",
         "wrong": [{"value": "0.25 m/s", "feedback": "Which way?"}]},
        {"id": "end", "type": "long", "ask": "And now?", "idea": "first",
         "rubric": {0: "no", 1: "half", 2: "yes"}},
        {"id": "open", "type": "single", "ask": "Left?", "options": ["x", {"text": "y",
         "correct": True}]},
    ],
})  # fmt: skip


def read(files: list[dict[str, Any]], source: Bank) -> tuple[Any, Any]:
    reading = Reading.of(sources(files))
    assert not reading.refused
    return [(one, WHOLE) for one in reading.files], read_key_file(keys(source))


def slip_of(values: Mapping[str, Any], student: str = "FOX-1", **asked: Any) -> FormSlip:
    (slip,) = made_slips([answers(RICH, student, "pre", values)], RICH, **asked)
    return slip.forms[0]


def made_slips(files: list[dict[str, Any]], source: Bank, **asked: Any) -> list[Slip]:
    read_, key = read(files, source)
    of_files = Keys(key)
    return slips(sorted_files(read_, of_files, Asked(**asked)).counted, of_files, (WHOLE,))


WRONG = {"first": "a", "push": "a", "speed": 0.25, "end": "Both <b>push</b>."}


def test_a_slip_sorts_every_question_that_is_worth_marks_into_one_place() -> None:
    slip = slip_of(WRONG)
    assert [look.number for look in slip.look] == [2, 3]  # sure first, then by number
    assert (slip.right, slip.open, slip.waiting, slip.also) == ((), (5,), (4,), ())
    assert slip.sure == (1, 0)


def test_a_slip_says_what_was_answered_and_the_authors_word_on_it() -> None:
    push, speed = slip_of(WRONG).look
    assert (push.answer, push.hints, push.right) == ("that on <A>", ("Look again.",), "neither")
    assert (speed.answer, speed.hints, speed.right) == ("0.25 m/s", ("Which way?",), "−0.25 m/s")


def test_the_first_idea_stands_beside_the_last_answer_and_marks_that_were_given() -> None:
    (given,) = slip_of(WRONG).given
    assert (given.idea, given.answer, given.marks) == ("Ana", "Both <b>push</b>.", None)
    (marked,) = slip_of(WRONG, given={("carts", "pre", "FOX-1", "end"): 2}).given
    assert (marked.marks, marked.of) == (2, 2)


def test_a_slip_speaks_about_few_questions_and_names_the_rest() -> None:
    values = {f"item-{k}": "abcd"[(k + 1) % 4] for k in range(8)}
    (slip,) = made_slips([answers(BANK, "FOX-1", "pre", values)], BANK)
    assert len(slip.forms[0].look) == MOST_TOLD
    told = [look.number for look in slip.forms[0].look]
    assert sorted([*told, *slip.forms[0].also]) == list(range(1, 9))


def test_a_slip_of_two_tests_speaks_about_as_few_questions() -> None:
    values = {f"item-{k}": "abcd"[(k + 1) % 4] for k in range(8)}
    files = [answers(BANK, "FOX-1", form, values) for form in ("pre", "post")]
    (slip,) = made_slips(files, BANK)
    assert sum(len(form.look) for form in slip.forms) == MOST_TOLD


def test_a_slip_says_of_what_its_numbers_are() -> None:
    values = {f"item-{k}": "abcd"[(k + 1) % 4] for k in range(8)}
    html = made_html("slips", [answers(BANK, "FOX-1", "pre", values)], BANK)
    assert "Also look at questions 5, 6, 7, 8" in html
    html = made_html("slips", [answers(RICH, "FOX-1", "pre", WRONG)], RICH)
    assert "Your teacher still reads question 4" in html


def test_students_stand_in_the_order_of_the_numbers_on_their_cards() -> None:
    files = random_class(BANK, 12)
    cards = [f"FOX-{k}" for k in range(12)]
    assert [slip.student for slip in made_slips(files, BANK)] == cards
    report = class_report(*read(files, BANK), (), Asked())
    for form in report["lessons"][0]["forms"]:
        assert [row["student"] for row in form["students"]] == cards


def test_before_and_after_of_one_student_are_one_slip() -> None:
    made = made_slips(random_class(BANK, 7), BANK)
    assert len(made) == 7
    assert {tuple(form.form for form in slip.forms) for slip in made} == {("pre", "post")}


def test_marks_of_the_slips_are_those_of_the_report() -> None:
    files = random_class(BANK, 9)
    report = class_report(*read(files, BANK), (), Asked())
    whole = {
        (row["student"], form["form"]): row["total"]
        for form in report["lessons"][0]["forms"]
        for row in form["students"]
    }
    told = {
        (slip.student, form.form): form.marks
        for slip in made_slips(files, BANK)
        for form in slip.forms
    }
    assert told == whole


def made_html(what: str, files: list[dict[str, Any]], source: Bank, **more: Any) -> str:
    wanted = Handout(what=what, words=words(more.get("language", "en")), **more)
    return handout_file(handout(*read(files, source), Asked(), wanted), wanted)


def test_one_answer_that_a_student_was_sure_of_is_no_answers() -> None:
    html = made_html("slips", [answers(RICH, "FOX-1", "pre", WRONG)], RICH)
    assert "You were sure of 1 answer: 0 right." in html


def test_right_answers_stand_on_slips_only_where_they_are_asked_for() -> None:
    files = [answers(RICH, "FOX-1", "pre", WRONG)]
    assert "neither" not in (without := made_html("slips", files, RICH))
    assert "They are a pair." not in without
    full = made_html("slips", files, RICH, answers=True)
    assert "Right: neither" in full and "They are a pair." in full


def test_what_a_student_or_an_author_wrote_is_text_and_never_markup() -> None:
    files = [answers(RICH, "<img src=x>", "pre", WRONG)]
    for what in ("slips", "sheet"):
        html = made_html(what, files, RICH)
        assert "<img" not in html and "<b>push" not in html and "<A>" not in html
    assert "&lt;img src=x&gt;" in made_html("slips", files, RICH)


def test_no_student_stands_on_the_page_of_the_class() -> None:
    html = made_html("sheet", random_class(BANK, 12, prefix="WREN"), BANK)
    assert "WREN" not in html
    assert html.count("carts-sheet-bar") > 8


def test_the_key_on_paper_has_answers_reasons_and_rubrics() -> None:
    key = read_key_file(keys(RICH, ("pre",)))
    html = handout([], key, Asked(), Handout(what="key", words={}))
    assert "Right: neither" in html and "Right: −0.25 m/s" in html
    assert "They are a pair." in html and "<b>2</b> yes" in html
    assert "that on <A>" not in html and html.count("<li>") == len(RICH.items)
    malay = handout([], key, Asked(), Handout(what="key", words=words("ms")))
    assert "Betul: neither" in malay and "Sebelum pelajaran" in malay


def test_first_ideas_stand_on_the_page_with_how_many_had_them() -> None:
    files = [answers(RICH, f"FOX-{k}", "pre", {"first": "ab"[k > 1]}) for k in range(6)]
    assert "Ben (4); Ana (2)" in made_html("sheet", files, RICH)


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_sentence_of_ours_is_told_in_the_language_of_the_paper(language: str) -> None:
    files = [answers(RICH, f"FOX-{k}", "pre", WRONG) for k in range(6)]
    english = {s for what in ("slips", "sheet") for s in told_in(made_html(what, files, RICH))}
    here = {
        s
        for what in ("slips", "sheet")
        for s in told_in(made_html(what, files, RICH, language=language))
    }
    if language != "en":
        own = {prose(item.common.ask) for item in RICH.items.values()}
        own |= {"Look again.", "Which way?", "From", "Carts", "Ana", "that on &lt;A&gt;"}
        same = {s for s in english & here if re.search(r"[A-Za-z]{4}", s)}
        assert {s for s in same if not any(part in s for part in own)} == set()
    assert (BELIEFS[BELIEF] in " ".join(here)) == (language == "en")


def told_in(html: str) -> set[str]:
    """What stands between the marks of a page, without its head."""
    body = html.split("<body", 1)[1]
    return {text.strip() for text in re.findall(r">([^<]+)<", body)}


def test_the_map_counts_beliefs_by_question_and_leaves_out_what_nobody_chose() -> None:
    def item(*choices: tuple[str, int]) -> dict[str, Any]:
        return {"choices": [{"says": says, "count": count} for says, count in choices]}

    found = belief_map([(1, item(("p", 2), ("p", 1), ("q", 0))), (4, item(("p", 0), ("r", 5)))])
    assert found.questions == (1, 4)
    assert found.rows == (("r", (None, 5)), ("p", (3, 0)))


@pytest.mark.parametrize(
    ("markdown", "plain"),
    [
        (r"From \(m_A\,\Delta v_A = -m_B\,\Delta v_B\)", "From m_A Δv_A = −m_B Δv_B"),
        (r"\(\dfrac{\Delta v}{a+b}\)", "Δv/(a+b)"),
        (r"What is $\frac{1}{2} m v_A$ and $$\Delta v$$?", "What is 1/2 m v_A and Δv?"),
        ("It costs $5 or $6", "It costs $5 or $6"),
        ("a *b* **c** and 2 * 3 * 4", "a b c and 2 * 3 * 4"),
        ("v_A and v_B", "v_A and v_B"),
        ("See [the rule](x.md) and `code`", "See the rule and code"),
        ("Look:\n\n| t | v |\n|---|:-:|\n| 1 s | 2 m/s |\n\nHow?", "Look: t, v; 1 s, 2 m/s; How?"),
        ("Is |v| larger?", "Is |v| larger?"),
    ],
)
def test_an_authors_markdown_becomes_plain_words(markdown: str, plain: str) -> None:
    assert prose(markdown) == plain


def test_a_slip_of_a_file_without_an_answer_says_so_and_gives_no_marks() -> None:
    (slip,) = made_slips([answers(BANK, "FOX-1", "pre", {})], BANK)
    told = slips_html([slip], telling({}))
    assert "Nothing is answered in this file." in told
    assert "carts-slip-marks" not in told and "Left open" not in told
