"""A form is taken before and after a lesson, and handed in."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from sim.classroom.files.codes import read_codes
from sim.classroom.files.keyed import read_key_file
from sim.lesson.form import Form
from sim.lesson.handin import decode
from sim.lesson.key_file import key_file
from sim.pages.blocks.extension import Page as MadePage
from tests.web.conftest import OpenPage
from tests.web.question.answering import continue_as, saved_file
from tests.web.question.question_site import BANK, question_site, questions_page, ready, write_page

__all__ = ["question_site"]  # a fixture

pytestmark = pytest.mark.browser


def forms() -> dict[str, Form]:
    made: MadePage = questions_page("test", (BANK / "test.md").read_text(encoding="utf-8"), BANK)[1]
    return {quiz.form.form: quiz.form for quiz in made.items.quizzes}


def hand_in(page: Page, form: str) -> None:
    quiz = page.locator(f'carts-quiz[data-form="{form}"]')
    quiz.locator(".carts-quiz-hand-in").click()
    expect(quiz.locator(".carts-quiz-no")).to_be_focused()  # Enter held down hands nothing in
    quiz.get_by_role("button", name="Hand in", exact=True).click()
    expect(quiz.locator(".carts-quiz-done")).to_contain_text("Handed in on")


@pytest.mark.one_browser
def test_a_form_is_taken_before_and_after_and_handed_in(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "test.html"))
    continue_as(page, "BLUE-FOX-27")
    pre, post = (page.locator(f'carts-quiz[data-form="{form}"]') for form in ("pre", "post"))
    expect(post.locator("carts-question").first).to_be_hidden()
    pre.get_by_label("forwards").check()
    pre.locator(".carts-q-sure").first.get_by_label("a guess").check()
    expect(pre.locator(".carts-quiz-left")).to_have_text("1 not answered yet")
    expect(pre.get_by_role("button", name="Check")).to_have_count(0)
    hand_in(page, "pre")
    expect(pre.locator("carts-question").first).to_be_hidden()
    page.locator(".carts-bar-open").click()
    expect(page.get_by_role("dialog")).to_contain_text("kept and not shown")
    assert "forwards" not in page.get_by_role("dialog").inner_text()
    page.keyboard.press("Escape")

    post.locator(".carts-quiz-word").fill("FALCO")
    post.locator(".carts-quiz-open").click()
    expect(post.locator(".carts-quiz-why")).to_contain_text("not the word")
    post.locator(".carts-quiz-word").fill(" falcon ")
    post.locator(".carts-quiz-open").click()
    post.get_by_label("zero").check()
    post.get_by_label("equal to that on the other").check()
    hand_in(page, "post")
    expect(post.locator(".carts-quiz-done")).to_be_focused()  # what is read out tells the code
    page.reload()
    ready(page)
    expect(pre.locator(".carts-quiz-done")).to_contain_text("Hand-in code:")

    files: list[dict[str, Any]] = [saved_file(page, k) for k in range(2)]
    by_form = {content["form"]: content for content in files}
    chosen = {
        form: {item["id"]: item["value"] for item in content["items"]}
        for form, content in by_form.items()
    }
    assert chosen == {
        "pre": {"net-force": "a"},
        "post": {"net-force": "b", "light-boat": "c"},
    }
    described = forms()
    for form, content in by_form.items():
        facts = described[form].facts()
        options = [count for _, count in facts["items"]]
        codes = decode(options, content["code"], f"{form}:{facts['hash']}")
        assert codes == ((1, 0) if form == "pre" else (2, 3))
    keyed = read_key_file(json.dumps(key_file("", "test", [], described.values())))
    typed = "\n".join(f"BLUE-FOX-27 {form} {one['code']}" for form, one in by_form.items())
    read, refused = read_codes(typed, keyed)
    assert not refused  # what the page prints is what class results read
    assert [{item.id: item.value for item in one.answers.items} for one in read] == [
        chosen[form] for form in by_form
    ]

    pre.locator(".carts-quiz-word").fill("harbour")
    pre.locator(".carts-quiz-open").click()
    expect(pre.get_by_label("forwards")).to_be_visible()
    expect(pre.get_by_label("forwards")).to_be_disabled()


NUMBERS = """title: Numbers
forms:
  both: [how-fast]
items:
  - id: how-fast
    type: number
    ask: A cart needs 2 s for 1 m. How fast is it?
    answer: 0.5 m/s
    tolerance: 0.01 m/s
    topics: [first-law]
"""
EXAM = "```quiz\nid: numbers\nform: pre\nmode: exam\nbank: numbers.yml\nuse: both\n```\n"


@pytest.mark.one_browser
def test_a_form_without_check_tells_a_number_that_cannot_be_read_and_asks_before_it_is_handed_in(
    open_page: OpenPage, question_site: Path, tmp_path: Path
) -> None:
    (tmp_path / "numbers.yml").write_text(NUMBERS, encoding="utf-8")
    page = ready(open_page(write_page(question_site, "numbers", EXAM, tmp_path)))
    box, told = (page.locator(f"carts-quiz .carts-q-{part}") for part in ("typed", "error"))
    box.fill("0,5,0")
    expect(told).to_contain_text("is not a number")
    quiz = page.locator("carts-quiz")
    quiz.locator(".carts-quiz-hand-in").click()
    expect(quiz.locator(".carts-quiz-sure-text")).to_contain_text("1 number cannot be read.")
    quiz.locator(".carts-quiz-no").click()
    box.fill("0,5")
    expect(told).to_be_hidden()
    quiz.locator(".carts-quiz-hand-in").click()
    expect(quiz.locator(".carts-quiz-sure-text")).not_to_contain_text("cannot be read")
