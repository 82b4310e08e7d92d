"""How long a film takes in the page: ten seconds of 1080p, from *Follow* to readings."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from playwright.sync_api import Page, expect, sync_playwright

from tests.film.collision import QUICK
from tests.film.maker import Stage, encoded, frames
from tests.web.conftest import CONTEXT, launch
from tests.web.figures.measured_site import build_measured

LONGEST = 240_000  # ms
STAGE = Stage(width=1920, height=1080, scale=960.0, radius=18.0, noise=2)
TOOK = """() => new Promise((done) => {
  const film = document.querySelector(".carts-film");
  const began = performance.now();
  new MutationObserver(() => {
    if (film.dataset.phase === "followed") done((performance.now() - began) / 1000);
  }).observe(film, { attributes: true });
  film.querySelector(".carts-film-follow").click();
})"""


def rows() -> list[dict[str, Any]]:
    """Seconds in both browsers."""
    times = np.arange(300) / 30
    motion = [0.3 + 0.09 * times, 1.5 - 0.02 * times]
    film = encoded(
        frames(STAGE, times, motion), times, STAGE, codec="libx264", kind="mp4", options=QUICK
    )
    places = [STAGE.place(float(x[0])) for x in motion]
    with tempfile.TemporaryDirectory() as name, sync_playwright() as driver:
        site = build_measured(Path(name) / "site")
        made = []
        for browser_name in CONTEXT:
            browser = launch(driver, browser_name)
            page = browser.new_context(**CONTEXT[browser_name]).new_page()
            page.goto((site / "empty.html").as_uri())
            made.append(_row(page, browser_name, film, [*places, *STAGE.ruler]))
            browser.close()
    return made


def _row(
    page: Page, browser_name: str, film: bytes, clicks: list[tuple[float, float]]
) -> dict[str, Any]:
    expect(page.locator("carts-measured[data-state=live]")).to_have_count(1, timeout=LONGEST)
    payload = {"name": "f.mp4", "mimeType": "video/mp4", "buffer": film}
    page.locator(".carts-measured-film-file").set_input_files([payload])  # type: ignore[list-item]
    view = page.locator(".carts-film-view")
    expect(page.locator("[data-aim=A]")).to_be_enabled(timeout=LONGEST)
    view.scroll_into_view_if_needed()
    box = view.bounding_box()
    assert box is not None
    for aim, (x, y) in zip(("A", "B", "one", "other"), clicks, strict=True):
        expect(page.locator(f"[data-aim={aim}]")).to_have_attribute("aria-pressed", "true")
        ratio = box["width"] / STAGE.width
        page.mouse.click(box["x"] + x * ratio, box["y"] + y * ratio)
    page.locator(".carts-film-length").fill("0.5")
    took = page.evaluate(TOOK)
    said = page.locator(".carts-film-say").inner_text()
    assert "300 frames. Nothing was lost" in said, said
    return {
        "name": f"300 frames of 1920 × 1080 followed, {browser_name}",
        "value": took,
        "unit": "s",
        "goal": 20.0,
        "reference": "H.264, file://, decoding and both marks",
    }
