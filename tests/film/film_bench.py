"""A film on a page with readings of real carts: chosen, its marks and ruler set."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page, expect

from tests.film.collision import QUICK, Filmed, filmed
from tests.film.maker import Stage
from tests.measured.makers import truth
from tests.web.figures.measured_bench import benches

__all__ = ["benches"]  # a fixture

MADE = truth()
STAGE = Stage(noise=3, tilt=0.02)
STARTS = 60_000  # ms; Python with scipy on a loaded computer
AIMS = ("A", "B", "one", "other")


@pytest.fixture(scope="module")
def film() -> Filmed:
    return filmed(MADE, STAGE, 60, codec="libx264", kind="mp4", options={**QUICK, "crf": "8"})


def choose(page: Page, name: str, content: bytes) -> None:
    payload = {"name": name, "mimeType": "video/webm", "buffer": content}
    page.locator(".carts-measured-film-file").set_input_files([payload])  # type: ignore[list-item]


def click(page: Page, x: float, y: float) -> None:
    """On the middle of a pixel of the frame."""
    view = page.locator(".carts-film-view")
    view.scroll_into_view_if_needed()
    box = view.bounding_box()
    assert box is not None
    ratio = box["width"] / float(view.evaluate("canvas => canvas.width"))
    page.mouse.click(box["x"] + (x + 0.5) * ratio, box["y"] + (y + 0.5) * ratio)


def set_up(page: Page, film: Filmed) -> None:
    """Marks, ruler and its length."""
    for aim, place in zip(AIMS, film.clicks(), strict=True):
        expect(page.locator(f"[data-aim={aim}]")).to_have_attribute("aria-pressed", "true")
        click(page, *place)
    expect(page.locator(".carts-film-say")).to_contain_text("Type how long the ruler is")
    page.locator(".carts-film-unit").select_option("cm")
    page.locator(".carts-film-length").fill("50")
