"""What the line at the foot of a page counts as done."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.question.answering import saved
from tests.web.question.question_site import question_site, ready

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

__all__ = ["question_site"]  # a fixture


def test_a_number_that_is_not_read_is_kept_and_not_counted(
    open_page: OpenPage, question_site: Path
) -> None:
    page = ready(open_page(question_site / "kinds.html"))
    count = page.locator(".carts-bar-count")
    for typed, done in (("fast", 0), ("0.3 kg", 0), ("0.3 m/s", 1), ("fast", 0)):
        page.locator("#how-fast input").fill(typed)
        saved(page, "how-fast")
        expect(count).to_have_text(re.compile(f"^{done} of "))
    page.reload()
    expect(ready(page).locator("#how-fast input")).to_have_value("fast")
