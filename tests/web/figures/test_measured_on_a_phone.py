"""The bench of readings on a narrow screen, where its letters are larger for its picture."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage
from tests.web.figures.measured_bench import LIVE, STARTS
from tests.web.figures.measured_site import build_measured

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

CUT = """() => [...document.querySelectorAll(".carts-measured-figure text")].filter((text) => {
  const { left, right, width } = text.getBoundingClientRect();
  const picture = text.ownerSVGElement;
  const [room, frame] = [picture, picture.closest(".carts")].map((one) =>
    one.getBoundingClientRect());
  const clips = getComputedStyle(picture).overflow !== "visible";
  const out = right > frame.right || left < frame.left || (clips && right > room.right);
  return width > 0 && out;
}).map((text) => text.textContent)"""

LABELS = ".carts-measured-figure text:not(.carts-measured-hint), .carts-measured-stage text"
HEIGHTS = """(texts) => texts.filter((one) => one.checkVisibility()).map((one) =>
  parseFloat(getComputedStyle(one).fontSize)
    * one.ownerSVGElement.getBoundingClientRect().width
    / one.ownerSVGElement.viewBox.baseVal.width)"""


def on_a_phone(folder: Path, open_page: OpenPage) -> Page:
    """A bench with the readings of a film, which can be worked with."""
    page = open_page(build_measured(folder) / "film.html")
    page.set_viewport_size({"width": 360, "height": 740})
    expect(page.locator(LIVE)).to_have_count(1, timeout=STARTS)
    return page


def test_no_number_of_an_axis_is_cut_off_or_small_on_a_phone(
    tmp_path: Path, open_page: OpenPage
) -> None:
    """The last instant stands at the end of its axis: of “2.0” one read “2.(”."""
    page = on_a_phone(tmp_path, open_page)
    rows = [f"{k / 20};{20 + k};{100}" for k in range(41)]  # until 2.0 s
    readings = tmp_path / "own.csv"
    readings.write_text("\n".join(["t [s];A [cm];B [cm]", *rows]) + "\n", encoding="utf-8")
    page.set_input_files(".carts-measured-file", readings)
    expect(page.locator(".carts-measured-figure .carts-tick-x").last).to_have_text("2.0")
    assert page.evaluate(CUT) == []
    assert min(page.locator(LABELS).evaluate_all(HEIGHTS)) >= 12  # px


def test_on_a_phone_the_fit_stands_below_its_sliders_and_says_what_it_found_there(
    tmp_path: Path, open_page: OpenPage
) -> None:
    page = on_a_phone(tmp_path, open_page)
    fit = page.locator(".carts-measured-fit")
    expect(fit).to_be_visible()
    tops = [
        part.evaluate("(part) => { part.hidden = false; return part.getBoundingClientRect().top; }")
        for part in (fit, *(page.locator(f".carts-measured-{n}") for n in ("result", "masses")))
    ]
    assert tops == sorted(tops)
