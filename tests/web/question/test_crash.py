"""A browser that is killed loses no answer that it called saved: 5 times, Firefox 3 times.

`make bench AREA=answers` kills at random times after the last key, whatever the page says.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Playwright

from tests.web.question.killed_browser import lost_answers
from tests.web.question.question_site import question_site

pytestmark = pytest.mark.browser

__all__ = ["question_site"]  # a fixture

DELAYS = (0.0, 0.0, 0.05, 0.5, 1.5)  # s


def test_no_answer_is_lost_when_the_browser_is_killed(
    driver: Playwright, browser_name: str, question_site: Path, tmp_path: Path
) -> None:
    file = question_site / "kinds.html"
    delays = DELAYS if browser_name == "chromium" else DELAYS[:3]  # Firefox takes 6 s to start
    assert lost_answers(driver, browser_name, tmp_path, file, delays, told=True) == []
