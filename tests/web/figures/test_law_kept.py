"""A reader's law is kept at every input, back before anything is typed, and never just gone."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.web.conftest import OpenPage, SharePage
from tests.web.figures.law_writing import HEAVY, SPRING, STARTS, bench, opened, press, write
from tests.web.question.answering import saved_file
from tests.web.question.broken_stores import WHEN_TOLD, late_store, tell_to_open

__all__ = ["bench"]  # a fixture

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]


def text_box(page: Page) -> Locator:
    return page.get_by_label("Your law, in Python")


def kept(page: Page, text: str) -> None:
    write(page, text)
    page.wait_for_selector("carts-law[data-kept]")


def test_keys_before_the_kept_law_is_back_do_not_take_its_place(
    open_page: OpenPage, bench: Path
) -> None:
    page = opened(open_page, bench)
    kept(page, HEAVY)
    page.add_init_script(late_store(WHEN_TOLD))
    page.reload()
    text_box(page).focus()
    page.keyboard.type("too early")
    expect(page.get_by_role("button", name="Run", exact=True)).to_be_disabled()
    tell_to_open(page)
    page.wait_for_selector("carts-law[data-state=live]", timeout=STARTS)
    expect(text_box(page)).to_have_value(HEAVY)
    expect(page.get_by_role("button", name="Run", exact=True)).to_be_enabled()
    text_box(page).press("End")
    page.keyboard.type("#")
    assert "#" in text_box(page).input_value()


def test_the_last_key_is_kept_when_the_page_is_left_soon_after(
    shared_page: SharePage, bench: Path
) -> None:
    page = opened(shared_page, bench)
    with page.expect_navigation():
        page.evaluate(
            """(text) => {
              const box = document.querySelector("carts-law textarea");
              box.value = text;
              box.dispatchEvent(new Event("input"));
              setTimeout(() => location.reload(), 100);
            }""",
            HEAVY,
        )
    page.wait_for_selector("carts-law[data-state=live]")
    expect(text_box(page)).to_have_value(HEAVY)


def test_who_begins_again_is_asked_and_loses_nothing(shared_page: SharePage, bench: Path) -> None:
    page = opened(shared_page, bench)
    start = text_box(page).input_value()
    kept(page, HEAVY)
    again = page.locator(".carts-law-again")
    again.get_by_role("button", name="Begin again").click()
    expect(again).to_contain_text("Yours stays")
    again.get_by_role("button", name="No").click()
    expect(text_box(page)).to_have_value(HEAVY)
    again.get_by_role("button", name="Begin again").click()
    again.locator(".carts-answers-yes").click()
    expect(text_box(page)).to_have_value(start)
    expect(text_box(page)).to_be_focused()
    expect(again.get_by_role("button", name="Begin again")).to_be_visible()
    page.wait_for_function("document.querySelector('.carts-bar[data-ready]')")
    assert [item["value"] for item in saved_file(page)["items"]] == [HEAVY, start]


def test_a_law_that_is_changed_in_one_tab_is_changed_in_the_other(
    shared_page: SharePage, bench: Path
) -> None:
    page = opened(shared_page, bench)
    other = page.context.new_page()
    other.goto(page.url)
    other.wait_for_selector("carts-law[data-state=live]", timeout=STARTS)
    write(page, HEAVY)
    expect(text_box(other)).to_have_value(HEAVY)
    press(other, "Run")
    assert [item["value"] for item in saved_file(other)["items"]] == [HEAVY]
    other.close()


def test_a_law_that_is_cleared_in_one_tab_is_not_brought_back_by_the_other(
    shared_page: SharePage, bench: Path
) -> None:
    page = opened(shared_page, bench)
    start = text_box(page).input_value()
    other = page.context.new_page()
    other.goto(page.url)
    other.wait_for_selector("carts-law[data-state=live]", timeout=STARTS)
    kept(page, HEAVY)
    expect(text_box(other)).to_have_value(HEAVY)
    page.locator(".carts-bar-open").click()
    page.get_by_role("button", name="Clear my answers here").click()
    page.get_by_role("button", name="Clear my answers").click()
    expect(text_box(other)).to_have_value(start)
    other.wait_for_selector("carts-law[data-state=live]", timeout=STARTS)
    kept(other, SPRING)
    assert [item["value"] for item in saved_file(other)["items"]] == [SPRING]
    other.close()


def test_one_press_on_judge_is_one_try(shared_page: SharePage, bench: Path) -> None:
    page = opened(shared_page, bench)
    write(page, SPRING)
    press(page, "Judge")
    expect(page.locator(".carts-law-verdicts li")).to_have_count(6)
    press(page, "Run")
    assert [item["tries"] for item in saved_file(page)["items"]] == [2]


def test_not_saved_is_said_as_long_as_it_is_so_and_by_nothing_else_taken_away(
    open_page: OpenPage, bench: Path
) -> None:
    page = opened(open_page, bench)
    unsaved = page.locator(".carts-unsaved")
    kept(page, HEAVY)
    expect(unsaved).to_have_text("")
    page.evaluate(
        """() => {
          const own = IDBObjectStore.prototype.put;
          IDBObjectStore.prototype.put = function () { this.transaction.abort(); };
          globalThis.makeRoom = () => { IDBObjectStore.prototype.put = own; };
        }"""
    )
    write(page, SPRING)
    expect(unsaved).to_have_text("Not saved")
    press(page, "Run")
    expect(page.locator(".carts-law-shown figcaption")).to_have_text("Your law")
    expect(unsaved).to_have_text("Not saved")
    page.evaluate("makeRoom()")
    write(page, SPRING + "# one more\n")
    expect(unsaved).to_have_text("")
