"""Answers are kept: in two tabs, without a database, over changes of a question."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.question.answering import saved, saved_file
from tests.web.question.broken_stores import (
    NO_DATABASE,
    WHEN_TOLD,
    again_with,
    late_store,
    tell_to_open,
)
from tests.web.question.question_site import question_site, ready

pytestmark = pytest.mark.browser

__all__ = ["question_site"]  # a fixture


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


@pytest.mark.one_browser
def test_answers_that_are_cleared_in_one_tab_are_gone_in_the_other(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    other = page.context.new_page()
    other.goto(page.url)
    ready(other)
    page.locator("#why textarea").fill("of whom sat here before")
    expect(other.locator("#why textarea")).to_have_value("of whom sat here before")
    other.evaluate("sessionStorage.setItem('carts-watched', '[\"a run\"]')")
    page.locator(".carts-bar-open").click()
    page.get_by_role("button", name="Clear my answers here").click()
    page.get_by_role("button", name="Clear my answers").click()
    expect(other.locator("#why textarea")).to_have_value("")
    assert other.evaluate("sessionStorage.getItem('carts-watched')") is None
    ready(other).locator("#resultant input").fill("mine")
    saved(other, "resultant")
    assert [item["value"] for item in saved_file(other)["items"]] == ["mine"]


def test_keys_before_the_store_is_open_destroy_no_earlier_answer(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    page.locator("#why textarea").fill("written yesterday")
    page.get_by_label("They are equal").check()
    saved(page, "why")
    saved(page, "pick-one")  # it is another write
    page.add_init_script(late_store(WHEN_TOLD))
    page.reload()
    page.locator("#why textarea").focus()
    page.keyboard.type("too early")
    page.get_by_label("The one on the van").click(force=True)
    expect(page.locator("#why .carts-q-saved")).to_have_text("Opening your answers …")
    tell_to_open(page)
    ready(page)
    expect(page.locator("#why textarea")).to_have_value("written yesterday")
    expect(page.get_by_label("They are equal")).to_be_checked()
    page.locator("#why textarea").press_sequentially("!")
    saved(page, "why")
    page.reload()
    tell_to_open(page)
    expect(page.locator("#why textarea")).to_have_value("written yesterday!")


UNLISTED = (
    """IDBObjectStore.prototype.getAll = () => { throw new DOMException("", "DataError"); };"""
)


@pytest.mark.one_browser
def test_a_store_that_cannot_be_read_is_told_and_nothing_is_written_over_what_is_there(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    page.locator("#why textarea").fill("written yesterday")
    saved(page, "why")
    other = again_with(page, UNLISTED)
    expect(other.locator("#why textarea")).to_have_value("")
    expect(other.get_by_role("alert")).to_contain_text("could not be opened")
    other.locator("#why textarea").fill("written today")
    saved(other, "why")
    kept = {item["value"] for item in saved_file(other)["items"]}
    assert kept == {"written today", "written yesterday"}


# A write is waited for some seconds; here that would be seconds of every run.
ENDLESS = """Object.defineProperty(IDBTransaction.prototype, 'oncomplete', { set() {} });
  const later = setTimeout;
  window.setTimeout = (does, ms, ...more) => later(does, ms === 4000 ? 500 : ms, ...more);"""


@pytest.mark.one_browser
def test_a_write_that_never_ends_is_told(open_page: OpenPage, question_site: Path) -> None:
    page = again_with(open_page(question_site / "kinds.html"), ENDLESS)
    page.locator("#why textarea").fill("on its way")
    expect(page.locator("#why .carts-q-saved")).to_have_text("Not saved")


@pytest.mark.one_browser
def test_one_text_that_is_cut_short_hides_none_of_the_others(
    open_page: OpenPage, question_site: Path
) -> None:
    page = again_with(open_page(question_site / "kinds.html"), NO_DATABASE)
    page.locator("#why textarea").fill("whole")
    page.get_by_label("They are equal").check()
    saved(page, "why")
    page.evaluate("""() => { for (const key of Object.keys(localStorage))
      if (!key.endsWith("#why") && key.includes("#")) localStorage.setItem(key, "{cut"); }""")
    page.reload()
    expect(ready(page).locator("#why textarea")).to_have_value("whole")


def test_without_a_database_answers_are_kept_as_texts(
    open_page: OpenPage, question_site: Path
) -> None:
    page = again_with(open_page(question_site / "kinds.html"), NO_DATABASE)
    page.locator("#why textarea").fill("kept")
    saved(page, "why")
    page.reload()
    expect(page.locator("#why textarea")).to_have_value("kept")


@pytest.mark.one_browser
def test_what_was_kept_as_text_while_the_database_was_closed_comes_back_with_it(
    open_page: OpenPage, question_site: Path
) -> None:
    first = open_page(question_site / "kinds.html")
    ready(first).locator("#why textarea").fill("before")
    saved(first, "why")
    page = again_with(first.context.new_page(), NO_DATABASE, first.url)
    expect(page.locator(".carts-bar-warning")).to_contain_text("could not be opened")
    page.locator("#why textarea").fill("between")
    saved(page, "why")
    page.get_by_label("They are equal").check()
    page.close()
    first.reload()
    expect(ready(first).locator("#why textarea")).to_have_value("between")
    expect(first.get_by_label("They are equal")).to_be_checked()
    kept = [item["value"] for item in saved_file(first)["items"] if item["id"] == "why"]
    assert kept == ["before", "between"]
    assert first.evaluate("() => Object.keys(localStorage).filter((k) => k.includes('#'))") == []


@pytest.mark.one_browser
def test_answers_to_a_changed_question_are_shown_beside_the_new_one(
    open_page: OpenPage, question_site: Path, tmp_path: Path
) -> None:
    from tests.web.question.question_site import ALL_KINDS, prepare, write_page

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
