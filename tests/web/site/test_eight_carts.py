"""A long row of carts on a phone: each number of the picture can be read."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.web.conftest import OpenPage
from tests.web.scene.given.widget_site import LIVE

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

CROSSED = """scene => {
  const texts = [...scene.querySelectorAll(".carts-velocity [data-part=text]")]
    .filter((one) => one.checkVisibility());
  const boxes = texts.map((one) => one.getBBox());
  const meet = (a, b) => a.x < b.x + b.width && b.x < a.x + a.width && a.y === b.y;
  return texts.flatMap((one, k) => texts.slice(0, k)
    .filter((_, n) => meet(boxes[k], boxes[n]))
    .map((other) => `${other.textContent} on ${one.textContent}`));
}"""
SEEK = """(scene, t) => {
  const time = scene.querySelector(".carts-scrub");
  time.value = String(t);
  time.dispatchEvent(new Event("input", { bubbles: true }));
}"""


def test_no_velocity_is_written_over_another_one(site: Path, open_page: OpenPage) -> None:
    page = open_page(site / "sandbox.html", viewport={"width": 360, "height": 740})
    scene = page.locator("#sandbox-eight[data-state=live]")
    scene.scroll_into_view_if_needed(timeout=LIVE)
    assert scene.locator(".carts-velocity:visible").count() == len("ABCDEFGH")
    for t in (0, 0.7, 0.9, 1.2, 2.6):
        scene.evaluate(SEEK, t)
        assert scene.evaluate(CROSSED) == [], t
