"""Questions in a page: answered by pointer and keyboard, saved, marked, brought back."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.question.answering import answer_everything, saved, saved_file
from tests.web.question.question_site import question_site, ready, write_page

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
def test_check_says_what_fits_the_answer_and_hints_come_one_by_one(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    one = page.locator("#pick-one")
    one.locator(".carts-q-check").click()
    expect(one.locator(".carts-q-error")).to_have_text("Answer first.")
    page.get_by_label("The one on the van").check()
    one.locator(".carts-q-check").click()
    expect(one.locator(".carts-q-feedback")).to_have_text(
        "Not yet. Think again. Compare the two arrows.", use_inner_text=True
    )
    one.locator(".carts-q-hint").click()
    expect(one.get_by_text("Look at both bumpers.")).to_be_visible()
    expect(one.get_by_text("Which object does each force act on?")).to_be_hidden()
    page.get_by_label("They are equal").check()
    expect(one.locator(".carts-q-feedback")).to_be_empty()
    one.locator(".carts-q-check").click()
    expect(one.locator(".carts-q-feedback")).to_contain_text("The two forces are a pair.")
    number = page.locator("#how-fast")
    for typed, told in (
        ("1,000", "can mean 1 or 1000"),
        ("3 kg", "does not fit here"),
        ("4.8", "You multiplied."),
        ("0,301", "Right."),
    ):
        number.locator("input").fill(typed)
        number.locator(".carts-q-check").click()
        expect(number).to_contain_text(told)
    why = page.locator("#why")
    why.locator("textarea").fill("Less mass.")
    why.locator(".carts-q-check").click()
    expect(why.locator(".carts-q-feedback")).to_contain_text("the mass is not")
    assert "Larger force on the light cart" not in page.content()  # the rubric is the teacher's


@pytest.mark.one_browser
def test_what_was_said_to_a_checked_answer_is_there_after_a_reload_until_it_changes(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    one = page.locator("#pick-one")
    said = one.locator(".carts-q-feedback")
    page.get_by_label("The one on the van").check()
    for _ in range(3):  # then the explanation is told as well
        one.locator(".carts-q-check").click()
    told = said.inner_text()
    assert "Compare the two arrows." in told and "The two forces are a pair." in told
    saved(page, "pick-one")
    page.reload()
    ready(page)
    expect(said).to_have_text(told, use_inner_text=True)
    page.get_by_label("They are equal").check()
    expect(said).to_be_empty()
    saved(page, "pick-one")
    page.reload()
    ready(page)
    expect(page.get_by_label("They are equal")).to_be_checked()
    expect(said).to_be_empty()
    items = {item["id"]: item for item in saved_file(page)["items"]}
    assert items["pick-one"]["tries"] == 3
    assert "judged" not in items["pick-one"]


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
    page.locator(".carts-bar-open").focus()
    page.keyboard.press("Enter")
    expect(page.get_by_role("dialog")).to_be_visible()
    page.keyboard.press("Escape")
    expect(page.get_by_role("dialog")).to_be_hidden()


def test_without_javascript_a_question_is_a_printed_one(
    open_page: OpenPage, question_site: Path, browser_name: str
) -> None:
    if browser_name == "firefox":
        pytest.skip("Firefox cannot be told to run no scripts through this driver")
    page = open_page(question_site / "kinds.html", java_script_enabled=False)
    expect(page.get_by_label("The one on the van")).to_be_visible()
    expect(page.locator("#why textarea")).to_be_visible()
    for hidden in (".carts-q-check", ".carts-q-hint", ".carts-q-up", ".carts-q-hints div"):
        expect(page.locator(hidden).first).to_be_hidden()
    page.emulate_media(media="print")
    expect(page.locator("#why .carts-q-write hr")).to_have_count(5)
    expect(page.locator("#why .carts-q-write")).to_be_visible()
    expect(page.locator("#story .carts-q-paper")).to_be_visible()
    page.goto((question_site / "test.html").as_uri())
    expect(page.locator("#small-pre carts-question").first).to_be_visible()
    expect(page.locator("#small-post carts-question").first).to_be_hidden()


def test_on_paper_stands_what_was_answered_or_a_line(
    open_page: OpenPage, question_site: Path, browser_name: str
) -> None:
    if browser_name == "firefox":
        pytest.skip("Firefox ESR cannot be told to print through this driver")
    page = ready(open_page(question_site / "kinds.html"))
    page.locator("#why textarea").fill("Same force,\nless mass.")
    saved(page, "why")
    page.emulate_media(media="print")
    expect(page.locator("#why .carts-q-printed")).to_have_text("Same force,\nless mass.")
    expect(page.locator("#why .carts-q-printed")).to_be_visible()
    expect(page.locator("#why .carts-q-write")).to_be_hidden()
    expect(page.locator("#resultant .carts-q-write")).to_be_visible()
    expect(page.locator(".carts-bar")).to_be_hidden()
    page.evaluate("document.documentElement.classList.add('carts-print-empty')")
    expect(page.locator("#why .carts-q-printed")).to_be_hidden()
    expect(page.locator("#why .carts-q-write")).to_be_visible()


IDEA = """# Two vans

```question
id: guess-first
type: idea
ask: Before you try. Who is right?
options: [Ana, Ben]
```

```question
id: think-again
type: long
ask: And now?
idea: guess-first
rubric:
  1: says what changed
  0: anything else
```
"""


@pytest.mark.one_browser
def test_a_first_idea_is_kept_never_marked_and_stands_beside_the_last_answer(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(write_page(question_site, "ideas", IDEA)))
    first = page.locator("#think-again .carts-q-first")
    page.get_by_label("Ana").check()
    saved(page, "guess-first")
    expect(page.locator("#guess-first .carts-q-check")).to_have_count(0)
    expect(page.locator("#guess-first .carts-q-feedback")).to_be_empty()
    expect(first).to_be_hidden()
    page.locator("#think-again textarea").fill("It was Ben.")
    expect(first).to_have_text("Your first idea was: A: Ana")
    page.reload()
    ready(page)
    expect(page.get_by_label("Ana")).to_be_checked()
    expect(first).to_have_text("Your first idea was: A: Ana")


# A scene that was watched, as the elements of scenes tell it (sim/web/src/scene/time/watch.js).
WATCH = """(scene) => {
  scene.dataset.watched = "";
  scene.dispatchEvent(new Event("carts-watched", { bubbles: true }));
}"""
SCENES = """() => {
  const scene = (id) => Object.assign(document.createElement("carts-scene"), { id });
  const question = document.getElementById("pick-one");
  question.before(scene("other"), document.createElement("h2"), scene("beside"));
}"""


@pytest.mark.one_browser
def test_the_press_that_was_right_and_the_answer_before_the_run_are_kept(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    page.evaluate(SCENES)
    one = page.locator("#pick-one")
    page.get_by_label("The one on the van").check()
    one.locator(".carts-q-check").click()
    page.locator("#other").evaluate(WATCH)  # stands under another heading
    page.get_by_label("The one on the trailer").check()
    page.locator("#beside").evaluate(WATCH)
    page.get_by_label("They are equal").check()
    for _ in range(2):  # what was right stays so
        one.locator(".carts-q-check").click()
    page.locator("#beside").evaluate(WATCH)
    page.locator("#resultant input").fill("zero")  # after the run, with nothing before it
    saved(page, "pick-one")
    saved(page, "resultant")
    items = {item["id"]: item for item in saved_file(page)["items"]}
    assert (items["pick-one"]["tries"], items["pick-one"]["right"]) == (3, 2)
    assert items["pick-one"]["before"]["value"] == "c"
    assert "before" not in items["resultant"] and "right" not in items["resultant"]
