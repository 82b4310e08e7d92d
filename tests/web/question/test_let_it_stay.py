"""With a full disk a browser frees what sites kept: where it can be asked not to, it is asked."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.web.conftest import OpenPage
from tests.web.question.answering import saved
from tests.web.question.question_site import question_site, ready

pytestmark = pytest.mark.browser

__all__ = ["question_site"]  # a fixture

COUNTED = """
window.asked = 0;
if (navigator.storage) navigator.storage.persist = () => {
  window.asked += 1;
  return Promise.reject(new Error("as a browser may that does not like to be asked"));
};
"""


def test_the_first_answer_asks_the_browser_once_and_only_one_that_asks_nobody(
    open_page: OpenPage,
    question_site: Path,
    site_server: Callable[[Path], str],
    browser_name: str,
) -> None:
    page = open_page(f"{site_server(question_site)}/kinds.html")
    page.add_init_script(COUNTED)
    page.reload()
    ready(page)
    assert page.evaluate("window.asked") == 0
    for text in ("the first", "another"):
        page.locator("#why textarea").fill(text)
        saved(page, "why")
    # Firefox would ask the reader, in a window over the lesson
    assert page.evaluate("window.asked") == (0 if browser_name == "firefox" else 1)


@pytest.mark.one_browser
def test_nobody_is_asked_to_let_a_folder_stay(open_page: OpenPage, question_site: Path) -> None:
    page = open_page(question_site / "kinds.html")
    page.add_init_script(COUNTED)
    page.reload()
    ready(page).locator("#why textarea").fill("on a stick")
    saved(page, "why")
    assert page.evaluate("window.asked") == 0
