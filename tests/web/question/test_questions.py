"""Questions in a page: answered by pointer and keyboard, saved, marked, brought back."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.question.answering import answer_everything, saved, saved_file
from tests.web.question.question_site import BANK, question_site, ready, write_page

pytestmark = pytest.mark.browser

__all__ = ["question_site"]  # a fixture


def test_every_kind_of_answer_is_kept_and_comes_back(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    expect(page.locator(".carts-bar-count")).to_have_text("0 of 7")
    answer_everything(page)
    expect(page.locator(".carts-bar-count")).to_have_text("7 of 7")
    order = page.locator("#story [data-line]").evaluate_all("all => all.map(x => x.dataset.line)")
    page.reload()
    ready(page)
    expect(page.locator("#pick-one .carts-q-saved")).to_have_text("Saved")
    expect(page.get_by_label("The one on the van")).to_be_checked()
    expect(page.locator("#pick-one .carts-q-sure").get_by_label("I think so")).to_be_checked()
    expect(page.get_by_label("the support by the road")).to_be_checked()
    expect(page.get_by_label("the force of motion")).not_to_be_checked()
    expect(page.locator("#how-fast input")).to_have_value("30 cm/s")
    expect(page.locator("#resultant input")).to_have_value("Zero!")
    expect(page.locator("#why textarea")).to_have_value("Same force,\nless mass. <b>Äöü</b> 力")
    assert order == ["a", "c", "b", "d"]
    again = page.locator("#story [data-line]").evaluate_all("all => all.map(x => x.dataset.line)")
    assert again == order
    expect(page.locator("#partners select").first).to_have_value("b")
    expect(page.locator("#how-sure").get_by_label("I am sure")).to_be_checked()


@pytest.mark.one_browser
def test_the_file_holds_every_answer_for_people_and_programs(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    answer_everything(page)
    content = saved_file(page)
    head = {name: content[name] for name in ("format", "kind", "site", "lesson", "student", "form")}
    assert head == {
        "format": 1,
        "kind": "newtons-carts-answers",
        "site": "question-tests",
        "lesson": "kinds",
        "student": "",
        "form": "worksheet",
    }
    items = {item["id"]: item for item in content["items"]}
    assert {name: item["value"] for name, item in items.items()} == {
        "pick-one": "a",
        "pick-many": ["a", "b"],
        "how-fast": 0.3,
        "resultant": "Zero!",
        "why": "Same force,\nless mass. <b>Äöü</b> 力",
        "story": ["a", "c", "b", "d"],
        "partners": {"1": "b"},
        "how-sure": "sure",
    }
    assert items["how-fast"]["unit"] == "m/s"
    assert items["how-fast"]["said"] == "30 cm/s"
    assert items["pick-one"]["sure"] == "think"
    assert items["pick-one"]["said"] == "A: The one on the van"
    assert items["partners"]["said"] == "force on A by B – force on B by A"
    for item in items.values():
        assert len(item["hash"]) == 12
        assert item["first"] <= item["last"]


@pytest.mark.one_browser
def test_an_option_that_is_a_picture_is_told_by_the_words_of_the_picture(
    open_page: OpenPage, question_site: Path
) -> None:
    asks = (
        "```question\nid: which\ntype: single\nask: Which way?\noptions:\n"
        "  - {text: '![an arrow to the left](left.png)', correct: true}\n"
        "  - '![an arrow to the right](right.png) of *two*'\n```\n"
    )
    page = ready(open_page(write_page(question_site, "pictured", asks)))
    told = []
    for option in ("a", "b"):
        page.locator(f"#which input[value={option}]").check()
        told.append(saved_file(page)["items"][0]["said"])
    assert told == ["A: an arrow to the left", "B: an arrow to the right of two"]


def test_the_keyboard_is_enough(open_page: OpenPage, question_site: Path) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    page.locator("#pick-one input").first.focus()
    page.keyboard.press("ArrowDown")
    expect(page.get_by_label("They are equal")).to_be_checked()
    page.locator('#story [data-line="c"] .carts-q-up').focus()
    page.keyboard.press("Enter")
    first = page.locator("#story [data-line]").evaluate_all("all => all.map(x => x.dataset.line)")
    assert first == ["a", "c", "b", "d"]
    focused = page.evaluate("document.activeElement.getAttribute('aria-label')")
    assert focused == "Move C up"
    expect(page.locator("#story .carts-q-picked")).to_contain_text("Now 2 of 4:")
    page.locator("#how-fast input").focus()
    page.keyboard.type("4.8")
    page.keyboard.press("Enter")
    expect(page.locator("#how-fast .carts-q-feedback")).to_contain_text("You multiplied.")
    page.locator(".carts-bar-open").focus()
    page.keyboard.press("Enter")
    expect(page.get_by_role("dialog")).to_be_visible()
    page.keyboard.press("Escape")
    expect(page.get_by_role("dialog")).to_be_hidden()


PRACTICE = """# Three weeks later

```quiz
id: small-practice
form: delayed
mode: practice
bank: small.yml
items: [ice-words, mass-words]
```
"""


@pytest.mark.one_browser
def test_questions_of_a_practice_form_count_among_those_of_the_page(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(write_page(question_site, "later", PRACTICE, BANK)))
    count = page.locator(".carts-bar-count")
    expect(count).to_have_text("0 of 2")
    page.locator("#small-practice carts-question textarea").first.fill("Because of the ice.")
    expect(count).to_have_text("1 of 2")


@pytest.mark.one_browser
@pytest.mark.browser
def test_of_pairs_each_that_was_joined_is_marked(open_page: OpenPage, question_site: Path) -> None:
    """“Partly right” did not say which, as a table does."""
    page = ready(open_page(question_site / "kinds.html"))
    pairs, marks = page.locator("#partners select"), page.locator("#partners .carts-q-cell-mark")
    right = page.locator("#partners [data-right]", has_text="force on B by A")
    pairs.nth(0).select_option(right.get_attribute("data-right"))
    page.locator("#partners .carts-q-check").click()
    expect(marks).to_have_text(["✓ right", ""])  # what was not joined is not wrong
    support = page.locator("#partners [data-right]", has_text="support on A")
    pairs.nth(1).select_option(support.get_attribute("data-right"))
    expect(marks).to_have_text(["", ""])
    page.locator("#partners .carts-q-check").click()
    expect(marks).to_have_text(["✓ right", "✗ not yet"])
    saved(page, "partners")
    page.reload()
    ready(page)
    expect(marks).to_have_text(["✓ right", "✗ not yet"])


@pytest.mark.one_browser
def test_what_moves_a_line_is_large_enough_for_a_finger(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html", has_touch=True, is_mobile=True))
    size = page.locator(".carts-q-moves .carts-button").first.bounding_box()
    assert size and min(size["width"], size["height"]) >= 44
