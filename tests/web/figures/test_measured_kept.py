"""What is kept of a bench of readings: nothing newer is lost to it; what is not kept is said."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.figures.measured_bench import LIVE, STARTS, benches, choose, opened
from tests.web.question.broken_stores import REFUSING, WHEN_TOLD, late_store, tell_to_open

__all__ = ["benches"]  # a fixture

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

ROWS = [f"{k / 30:.4f};{0.2 + 0.5 * k / 30:.4f};0.9" for k in range(30)]
TEXT = "\n".join(["t (s);x_A (m);x_B (m)", *ROWS])


def test_a_file_opened_before_the_kept_readings_are_back_is_the_one_that_stays(
    benches: Path, open_page: OpenPage
) -> None:
    page = opened(open_page, benches / "empty.html")
    expect(page.locator(LIVE)).to_have_count(1, timeout=STARTS)
    said = page.locator(".carts-measured-said")
    choose(page, "yesterday.csv", TEXT)
    expect(said).to_contain_text("yesterday.csv", timeout=STARTS)
    page.add_init_script(late_store(WHEN_TOLD))
    page.reload()
    choose(page, "today.csv", TEXT)
    expect(page.locator(".carts-measured-paste textarea")).to_be_disabled()
    tell_to_open(page)
    expect(said).to_contain_text("today.csv", timeout=STARTS)
    expect(page.locator(".carts-measured-paste textarea")).to_be_enabled()
    page.wait_for_function("document.querySelector('carts-measured').complete")
    expect(said).to_contain_text("today.csv")


def test_readings_that_the_browser_does_not_keep_are_said_to_be_not_saved(
    benches: Path, open_page: OpenPage
) -> None:
    page = opened(open_page, benches / "empty.html")
    expect(page.locator(LIVE)).to_have_count(1, timeout=STARTS)
    page.evaluate(f"() => {{ {REFUSING} }}")
    choose(page, "ours.csv", TEXT)
    expect(page.locator(".carts-unsaved")).to_have_text("Not saved")


def test_of_the_lessons_own_readings_nobody_is_told_that_they_are_not_saved(
    benches: Path, open_page: OpenPage
) -> None:
    page = opened(open_page, benches / "empty.html")
    page.add_init_script(REFUSING)
    page.goto((benches / "film.html").as_uri())
    expect(page.locator(LIVE)).to_have_count(1, timeout=STARTS)
    page.wait_for_function("document.querySelector('carts-measured').complete")
    expect(page.locator(".carts-unsaved")).to_have_text("")
