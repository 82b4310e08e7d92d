"""Opens the site in a place without any network; run by test_no_network in an empty namespace."""

from __future__ import annotations

import socket
import sys
from pathlib import Path

from playwright.sync_api import sync_playwright

from tests.web.conftest import launch


def main(site: Path) -> None:
    """Print the states of all scenes of the lesson, or fail."""
    names = [name for _, name in socket.if_nameindex()]
    assert names == ["lo"], f"there is a network here: {names}"
    with sync_playwright() as driver:
        browser = launch(driver, "chromium")
        page = browser.new_page()
        page.goto((site / "index.html").as_uri())
        page.evaluate("document.querySelector('carts-scene').ready")
        page.evaluate("document.querySelector('carts-scene').set({'A.mass': 2})")
        print(page.evaluate("document.querySelector('carts-scene').dataset.state"))
        page.goto((site / "worksheets" / "newtons-first-law.html").as_uri())
        page.evaluate(
            "Promise.all([...document.querySelectorAll('carts-scene')].map(s => s.ready))"
        )
        print(
            page.locator("carts-scene[data-state=live]").count(),
            page.locator("carts-scene").count(),
        )
        browser.close()


if __name__ == "__main__":
    main(Path(sys.argv[1]))
