"""axe-core finds nothing to complain of on any page: live, everything opened.

Colours in the dark are looked at in test_site_looks.py.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.web.boot_site import ROOT
from tests.web.conftest import OpenPage
from tests.web.pages_of import pages

pytestmark = [pytest.mark.browser, pytest.mark.one_browser, pytest.mark.slow]

OPEN_ALL = "for (const part of document.querySelectorAll('details')) part.open = true"
RUN = """axe.run(document, { resultTypes: ["violations"] })
  .then(({ violations }) => violations.map(({ id, nodes }) =>
    [id, ...nodes.slice(0, 3).map(({ target }) => target.join(" "))]))"""


def test_every_page_passes_axe(site: Path, open_page: OpenPage) -> None:
    axe = (ROOT / "node_modules" / "axe-core" / "axe.min.js").read_text(encoding="utf-8")
    page = open_page(site / "index.html")
    for name in pages(site):
        page.goto((site / name).as_uri())
        page.wait_for_load_state()
        for scene in page.locator("carts-scene").all():
            scene.and_(page.locator('[data-state="live"]')).wait_for(state="attached")
        page.evaluate(OPEN_ALL)
        page.evaluate(axe)
        assert page.evaluate(RUN) == [], name
