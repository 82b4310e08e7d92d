"""“Download this lesson”: from a web server to one file that opens by double click."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.scene.given.widget_site import LIVE

pytestmark = [pytest.mark.browser, pytest.mark.slow]

LESSON = "newtons-first-law"


@pytest.mark.one_browser  # test_single_file.py opens such files in both
def test_a_lesson_that_was_downloaded_is_live_alone_in_a_folder(
    hosted_site: Path, site_server: Callable[[Path], str], open_page: OpenPage, tmp_path: Path
) -> None:
    page = open_page(f"{site_server(hosted_site)}/worksheets/{LESSON}.html")
    place = page.locator(".carts-hosted")
    with page.expect_download(timeout=LIVE * 3) as saving:
        place.get_by_role("button", name="Download this lesson").click()
    alone = tmp_path / "alone" / saving.value.suggested_filename
    assert alone.name == f"{LESSON}.html"
    saving.value.save_as(alone)
    expect(place.get_by_role("status")).to_contain_text("MB")
    text = alone.read_text(encoding="utf-8")
    assert "data-from=" not in text
    page = open_page(alone)
    page.wait_for_selector('carts-scene[data-state="live"]', timeout=LIVE * 2)
    assert page.locator(".carts-hosted").count() == 0


def test_shells_hold_no_python_and_a_site_for_double_click_has_none(
    hosted_site: Path, site: Path
) -> None:
    shells = list((hosted_site / "assets" / "carts" / "download").glob("*.txt"))
    lessons = list((hosted_site / "worksheets").glob("*.html"))
    assert len(shells) == len(lessons)
    assert all(shell.stat().st_size < 1_500_000 for shell in shells)
    assert not (site / "assets" / "carts" / "download").exists()
    assert "carts-hosted" not in (site / "worksheets" / f"{LESSON}.html").read_text("utf-8")
