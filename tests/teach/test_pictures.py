"""The pictures in the guide “Change a lesson in its page”, taken from the page itself.

    CARTS_PICTURES=1 python -m pytest tests/teach/test_pictures.py

takes them anew into docs/assets/howto/. What they show is tested in test_teacher_page.py.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, Playwright

from tests.teach.conftest import ROOT
from tests.web.conftest import launch

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(not os.environ.get("CARTS_PICTURES"), reason="CARTS_PICTURES=1 takes them"),
]

HOWTO = ROOT / "docs" / "assets" / "howto"
LESSON = "worksheets/newtons-first-law.html"
READY = ".carts-teach[data-state=ready]"


@pytest.fixture
def chromium(driver: Playwright) -> Browser:
    return launch(driver, "chromium")


def teacher(page: Page, lessons: Path) -> None:
    page.goto((lessons / LESSON).as_uri() + "#teacher")
    page.wait_for_selector(READY, timeout=60_000)
    page.get_by_role("button", name="Change this scene").first.dispatch_event("click")


def settled(page: Page) -> None:
    page.wait_for_timeout(600)
    page.wait_for_selector(READY, timeout=60_000)
    page.wait_for_selector("carts-scene[data-state=live]", timeout=60_000)
    page.wait_for_timeout(1200)


def test_the_pictures_are_taken(lessons: Path, chromium: Browser) -> None:
    HOWTO.mkdir(parents=True, exist_ok=True)
    page = chromium.new_page(
        viewport={"width": 1200, "height": 760}, device_scale_factor=0.75
    )  # a page without Python stays light
    teacher(page, lessons)
    mass = page.locator(".carts-teach-piece[open]").get_by_label("mass", exact=True).first
    mass.fill("1.5 kg")
    settled(page)
    page.locator("carts-scene").first.evaluate("scene => scene.scrollIntoView()")
    page.screenshot(path=HOWTO / "teacher-mode.png")
    mass.fill("-1.5 kg")
    settled(page)
    page.locator(".carts-teach-piece[open] .carts-teach-text summary").first.click()
    page.locator(".carts-teach-mistakes:visible").scroll_into_view_if_needed()
    page.locator(".carts-teach").screenshot(path=HOWTO / "teacher-mode-mistake.png")
    page.close()
    phone = chromium.new_page(viewport={"width": 360, "height": 740}, color_scheme="dark")
    teacher(phone, lessons)
    settled(phone)
    phone.locator("carts-scene").first.evaluate("scene => scene.scrollIntoView()")
    phone.screenshot(path=HOWTO / "teacher-mode-phone.png")
    chromium.close()
