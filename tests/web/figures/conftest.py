"""Figures compute for long: their browser compiles Python for speed, as a reader's does."""

from __future__ import annotations

import pytest
from playwright.sync_api import Browser, Playwright

from tests.web.conftest import running


@pytest.fixture(scope="session")
def browser(driver: Playwright, browser_name: str) -> Browser:
    return running(driver, browser_name, briefly=False)
