"""A page with readings of real carts, opened, and a file chosen in it."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page

from tests.conftest import made_once
from tests.web.conftest import OpenPage, SharePage
from tests.web.figures.measured_site import build_measured

LIVE = "carts-measured[data-state=live]"
STARTS = 60_000  # ms; Python with scipy on a loaded computer


@pytest.fixture(scope="session")
def benches(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same for all files of tests and all workers."""
    return made_once(tmp_path_factory, "measured", build_measured)


def opened(open_page: OpenPage | SharePage, place: Path) -> Page:
    page = open_page(place)
    page.on("pageerror", lambda error: pytest.fail(str(error)))
    return page


def choose(page: Page, name: str, text: str) -> None:
    payload = {"name": name, "mimeType": "text/plain", "buffer": text.encode("utf-8-sig")}
    page.locator(".carts-measured-file").set_input_files([payload])  # type: ignore[list-item]
