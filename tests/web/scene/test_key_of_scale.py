"""Below the picture a key says how long the arrows are, and that it is a key."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.web.conftest import OpenPage
from tests.web.scene.given.widget_site import (
    MEETING,
    in_windows,
    live,
    on_scene,
    widget_site,
    write_page,
)

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

__all__ = ["widget_site"]  # a fixture

QUIET: dict[str, Any] = {**MEETING, "id": "quiet", "forces": "hidden"}
SPOILT = """
  const stage = [...el.querySelectorAll(".carts-stage")].find((s) => s.clientWidth);
  const frame = stage.getBoundingClientRect();
  const word = stage.querySelector(".carts-legend text");
  const rest = [...stage.querySelectorAll(".carts-legend path, .carts-legend text, .carts-number")];
  return ["inherit", "serif", "sans-serif"].flatMap((font) => {
    stage.style.fontFamily = font;
    const own = word.getBoundingClientRect();
    const outside = own.left < frame.left || own.right > frame.right || own.width === 0;
    const low = own.bottom - own.height / 5; // the room for tails of letters, which it has not
    const met = rest.filter((one) => one !== word).filter((one) => {
      const other = one.getBoundingClientRect();
      const foot = other.bottom - (one.tagName === "text" ? other.height / 5 : 0);
      const shaft = one.matches(".carts-block-arrow") && own.right < other.right - 9;
      const head = other.top + (shaft ? other.height / 4 : 0); // half as high as its tip
      return own.left < other.right && other.left < own.right && own.top < foot && head < low;
    });
    return [...(outside ? [`${font}: outside`] : []),
      ...met.map((one) => `${font}: ${one.textContent || one.getAttribute("class")}`)];
  });"""


WIDTHS = (360, 1000)  # the page holds both pictures, its style shows one


@pytest.mark.parametrize("fence", [MEETING, QUIET], ids=["forces", "no-forces"])
def test_the_arrows_of_the_key_are_called_a_scale(
    open_page: OpenPage, widget_site: Path, fence: dict[str, Any]
) -> None:
    file = write_page(widget_site, f"key-{fence['id']}", fence)
    page = live(open_page(file), fence["id"])
    for _ in in_windows(page, WIDTHS, 700):
        first = page.locator(f"#{fence['id']} .carts-legend:visible text").first
        assert first.text_content() == "scale:"
        assert on_scene(page, SPOILT, name=fence["id"]) == []


CLEAR = """
  const stage = [...el.querySelectorAll(".carts-stage")].find((s) => s.clientWidth);
  const word = stage.querySelector(".carts-legend text").getBBox();
  const numbers = [...stage.querySelectorAll(".carts-number")].map((one) => one.getBBox());
  return word.y - Math.max(...numbers.map((one) => one.y + one.height));"""


def test_the_word_stands_clear_of_the_numbers_of_the_ruler(
    open_page: OpenPage, widget_site: Path
) -> None:
    """Before, where it stands above its arrows, both stood line on line. On a wide page it does so
    where a box may tear: that needs the room behind the arrows."""
    fence = {**MEETING, "id": "clear"}
    page = live(open_page(write_page(widget_site, "key-clear", fence)), "clear")
    for _ in in_windows(page, WIDTHS, 700):
        assert on_scene(page, CLEAR, name="clear") >= 4  # units, about pixels
