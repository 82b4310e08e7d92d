"""A reader who writes a law in a page, for the tests of it."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page

from tests.web.conftest import OpenPage, SharePage
from tests.web.figures.law_site import build_law

STARTS = 60_000  # ms; Python on a loaded computer
SPRING = "def force(overlap, rate):\n    return 100 * overlap\n"
HEAVY = "def force(overlap, rate, mass_other):\n    return 100 * mass_other * overlap\n"


@pytest.fixture(scope="module")
def bench(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build_law(tmp_path_factory.mktemp("law"))


def opened(open_page: OpenPage | SharePage, bench: Path) -> Page:
    page = open_page(bench / "law.html")
    page.on("pageerror", lambda error: pytest.fail(str(error)))
    page.wait_for_selector("carts-law[data-state=live]", timeout=STARTS)
    return page


def write(page: Page, text: str) -> None:
    page.get_by_label("Your law, in Python").fill(text)


def press(page: Page, name: str) -> None:
    page.get_by_role("button", name=name, exact=True).click()
    page.wait_for_function(
        "() => !document.querySelector('carts-law').hasAttribute('data-working')", timeout=STARTS
    )
