"""Browsers that keep nothing, or have no room: the page says so, and a file is still saved."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.question.answering import saved, saved_file
from tests.web.question.broken_stores import (
    BLOCKED,
    NO_DATABASE,
    NO_TEXT_STORE,
    REFUSING,
    again_with,
)
from tests.web.question.question_site import question_site, ready

pytestmark = pytest.mark.browser

__all__ = ["question_site"]  # a fixture


@pytest.mark.parametrize(
    "script",
    [
        pytest.param(NO_DATABASE + NO_TEXT_STORE, marks=pytest.mark.one_browser),
        BLOCKED,
        pytest.param(REFUSING, marks=pytest.mark.one_browser),
    ],
    ids=["none", "blocked", "full"],
)
def test_where_nothing_can_be_kept_the_page_says_so_and_still_saves_a_file(
    open_page: OpenPage, question_site: Path, script: str
) -> None:
    page = again_with(open_page(question_site / "kinds.html"), script)
    page.locator("#why textarea").fill("only here")
    expect(page.locator("#why .carts-q-saved")).to_have_text("Not saved")
    expect(page.locator(".carts-bar-warning")).to_contain_text("file")
    items = saved_file(page)["items"]
    assert [item["value"] for item in items] == ["only here"]


@pytest.mark.one_browser
def test_where_nothing_can_be_kept_a_code_word_loses_no_answer(
    open_page: OpenPage, question_site: Path
) -> None:
    """The page is not read anew for it: that would forget all."""
    page = again_with(open_page(question_site / "kinds.html"), NO_DATABASE + NO_TEXT_STORE)
    page.locator("#why textarea").fill("only here")
    page.locator(".carts-bar-open").click()
    page.locator(".carts-answers-code").fill("BLUE-FOX-27")
    page.locator(".carts-answers-go").click()
    page.get_by_role("button", name="They are mine").click()
    expect(page.locator(".carts-bar-who")).to_have_text("BLUE-FOX-27")
    expect(page.locator(".carts-answers-now")).to_contain_text("BLUE-FOX-27")
    page.locator(".carts-answers-close").click()
    content = saved_file(page)
    assert content["student"] == "BLUE-FOX-27"
    assert [item["value"] for item in content["items"]] == ["only here"]
    expect(page.locator("#why textarea")).to_have_value("only here")


@pytest.mark.one_browser
def test_a_code_word_that_a_full_browser_refuses_is_told(
    open_page: OpenPage, question_site: Path
) -> None:
    page = again_with(open_page(question_site / "kinds.html"), REFUSING)
    page.locator(".carts-bar-open").click()
    page.locator(".carts-answers-code").fill("BLUE-FOX-27")
    page.locator(".carts-answers-go").click()
    expect(page.locator(".carts-answers-who [role=status]")).to_contain_text("refuses")


def test_a_database_that_the_browser_closed_is_opened_anew(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    page.evaluate("""() => {
      const begin = IDBDatabase.prototype.transaction;
      IDBDatabase.prototype.transaction = function (...all) {
        if (window.first === undefined) window.first = this;
        if (window.first === this) throw new DOMException("closed", "InvalidStateError");
        return begin.apply(this, all);
      };
    }""")
    page.locator("#why textarea").fill("kept all the same")
    saved(page, "why")
    page.reload()
    expect(page.locator("#why textarea")).to_have_value("kept all the same")
