"""No page of the built site breaks its policy, complains or jumps, from disk and from a server."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.web.conftest import OpenPage
from tests.web.site.pages_of import (
    COUNT_SHIFTS,
    MOST_SHIFT,
    listen,
    of_each_kind,
    settle,
    shift_of,
)

pytestmark = [pytest.mark.browser, pytest.mark.slow]


def test_no_page_breaks_its_policy_from_disk(
    site: Path, open_page: OpenPage, browser_name: str
) -> None:
    """One of each kind in Firefox."""
    if browser_name == "chromium":
        pytest.skip("all pages are visited in Chromium: see test_every_page.py")
    page = open_page(site / "index.html")
    heard = listen(page)
    for name in of_each_kind(site):
        page.goto((site / name).as_uri())
        settle(page)
    assert heard == []


@pytest.mark.one_browser
def test_no_page_breaks_its_policy_or_jumps_on_a_desktop_from_a_server(
    hosted_site: Path,
    open_page: OpenPage,
    site_server: Callable[[Path], str],
) -> None:
    """Only Chromium counts how far things move; Firefox visits all kinds from disk, above."""
    address, moved = site_server(hosted_site), {}
    page = open_page(f"{address}/index.html", viewport={"width": 1280, "height": 800})
    page.add_init_script(COUNT_SHIFTS)
    heard = listen(page)
    for name in of_each_kind(hosted_site):
        page.goto(f"{address}/{name}")
        moved[name] = shift_of(page)
    assert heard == []
    assert {name: far for name, far in moved.items() if far > MOST_SHIFT} == {}


@pytest.mark.one_browser
def test_a_site_made_for_disks_works_from_a_server_too(
    site: Path, open_page: OpenPage, site_server: Callable[[Path], str]
) -> None:
    names = ["index.html", "worksheets/newtons-first-law.html"]
    assert heard_from(site_server(site), names, open_page) == []


def heard_from(address: str, names: list[str], open_page: OpenPage) -> list[str]:
    page = open_page(f"{address}/index.html")
    heard = listen(page)
    for name in names:
        page.goto(f"{address}/{name}")
        settle(page)
    return heard
