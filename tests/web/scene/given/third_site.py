"""A scene of two carts that bump, with views beside it, at the greatest force."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page

from tests.web.conftest import SharePage
from tests.web.scene.given.widget_site import MEETING, live, on_scene, widget_site, write_page

__all__ = ["widget_site"]  # a fixture

THIRD: dict[str, Any] = {
    **MEETING,
    "id": "third",
    "with": ["free-body", "lens", "bars"],
    "show": ["v", "F"],
}
AT_PEAK = "el.time = el.trajectory.events.find((e) => e.kind === 'peak').t;"


@pytest.fixture
def third(shared_page: SharePage, widget_site: Path) -> Page:
    page = live(shared_page(write_page(widget_site, "third", THIRD)), "third")
    on_scene(page, AT_PEAK, name="third")
    return page
