"""Questions in a page: answered by pointer and keyboard, saved, marked, brought back."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from sim.lesson.answer_file import read_answer_file
from tests.web.conftest import OpenPage
from tests.web.question_site import question_site, ready

pytestmark = pytest.mark.browser

__all__ = ["question_site"]  # a fixture

KEEP_FILES = """() => {
  const make = URL.createObjectURL;
  window.files = [];
  URL.createObjectURL = (blob) => { window.files.push(blob); return make.call(URL, blob); };
}"""


def saved(page: Page, question: str) -> None:
    expect(page.locator(f"#{question} .carts-q-saved")).to_have_text("Saved")


def answer_everything(page: Page) -> None:
    page.get_by_label("The one on the van").check()
    page.locator("#pick-one .carts-q-sure").get_by_label("I think so").check()
    page.get_by_label("its weight").check()
    page.get_by_label("the support by the road").check()
    page.locator("#how-fast input").fill("30 cm/s")
    page.locator("#resultant input").fill("Zero!")
    page.locator("#why textarea").fill("Same force,\nless mass. <b>Äöü</b> 力")
    page.locator('#story [data-line="b"] .carts-q-down').click()
    page.locator("#partners select").first.select_option("b")
    page.locator("#how-sure").get_by_label("I am sure").check()
    for question in ("pick-one", "pick-many", "how-fast", "resultant", "why", "story"):
        saved(page, question)
    saved(page, "partners")
    saved(page, "how-sure")


def saved_file(page: Page, k: int = 0) -> dict[str, Any]:
    """The answer file that “Save file” makes."""
    page.locator(".carts-bar-open").click()
    page.evaluate(KEEP_FILES)
    page.locator(".carts-answers-save").nth(k).click()
    text = page.evaluate("window.files[0].text()")
    page.locator(".carts-answers-close").click()
    read_answer_file(text)
    return dict(json.loads(text))


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


def test_two_tabs_show_the_same_answers_and_lose_none(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    other = page.context.new_page()
    other.goto(page.url)
    ready(other)
    for k in range(5):
        page.locator("#why textarea").fill(f"left {k}")
        other.locator("#resultant input").fill(f"right {k}")
        expect(other.locator("#why textarea")).to_have_value(f"left {k}")
        expect(page.locator("#resultant input")).to_have_value(f"right {k}")
    other.get_by_label("They are equal").check()
    expect(page.get_by_label("They are equal")).to_be_checked()
    page.reload()
    ready(page)
    expect(page.locator("#why textarea")).to_have_value("left 4")
    expect(page.locator("#resultant input")).to_have_value("right 4")


NO_DATABASE = "Object.defineProperty(window, 'indexedDB', { get() { throw new Error('no'); } });"
NO_TEXT_STORE = (
    "Object.defineProperty(window, 'localStorage', { get() { throw new Error('no'); } });"
)
REFUSING = """IDBObjectStore.prototype.put = () => {
  throw new DOMException("full", "QuotaExceededError");
};"""


def again_with(page: Page, script: str) -> Page:
    page.add_init_script(script)
    page.reload()
    return ready(page)


def test_without_a_database_answers_are_kept_as_texts(
    open_page: OpenPage, question_site: Path
) -> None:
    page = again_with(open_page(question_site / "kinds.html"), NO_DATABASE)
    page.locator("#why textarea").fill("kept")
    saved(page, "why")
    page.reload()
    expect(page.locator("#why textarea")).to_have_value("kept")


@pytest.mark.parametrize("script", [NO_DATABASE + NO_TEXT_STORE, REFUSING], ids=["none", "full"])
def test_where_nothing_can_be_kept_the_page_says_so_and_still_saves_a_file(
    open_page: OpenPage, question_site: Path, script: str
) -> None:
    page = again_with(open_page(question_site / "kinds.html"), script)
    page.locator("#why textarea").fill("only here")
    expect(page.locator("#why .carts-q-saved")).to_have_text("Not saved")
    expect(page.locator(".carts-bar-warning")).to_contain_text("file")
    items = saved_file(page)["items"]
    assert [item["value"] for item in items] == ["only here"]


def test_answers_to_a_changed_question_are_shown_beside_the_new_one(
    open_page: OpenPage, question_site: Path, tmp_path: Path
) -> None:
    from tests.web.question_site import ALL_KINDS, prepare, write_page

    site = prepare(tmp_path / "site")
    place = write_page(site, "kinds", ALL_KINDS)
    page = ready(open_page(place))
    page.get_by_label("They are equal").check()
    page.locator("#why textarea").fill("because")
    saved(page, "pick-one")
    saved(page, "why")
    changed = ALL_KINDS.replace("They are equal", "Their sizes are the same")
    write_page(site, "kinds", changed.replace("id: why\n", "id: why-else\n"))
    page.reload()
    ready(page)
    expect(page.locator("#pick-one .carts-q-earlier")).to_contain_text("B: They are equal")
    expect(page.locator("#pick-one input:checked")).to_have_count(0)
    page.get_by_label("The one on the trailer").check()
    saved(page, "pick-one")
    items = saved_file(page)["items"]
    assert [i["said"] for i in items if i["id"] == "pick-one"] == [
        "B: They are equal",
        "C: The one on the trailer",
    ]
    assert [i["value"] for i in items if i["id"] == "why"] == ["because"]
    page.locator(".carts-bar-open").click()
    expect(page.get_by_role("dialog")).to_contain_text("no longer on this page")
