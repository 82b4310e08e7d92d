"""What a reader of a map waits for: numpy, the first live picture, a dragged slider.

Chromium, from file://, on the page *Maps of outcomes* as `make site` builds it.
"""

from __future__ import annotations

import statistics
import tempfile
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, sync_playwright

from sim.cli.site.build import build_site
from tests.web.conftest import launch

ROOT = Path(__file__).parents[2]
OPENINGS = 3
MOVES = 40
POINTS = 181 * 201
MAP = "#map-velocity"


def rows() -> list[dict[str, Any]]:
    """One row per goal of maps in the page."""
    with tempfile.TemporaryDirectory() as name, sync_playwright() as driver:
        site = build_site(ROOT, hosted=False, strict=True, site_dir=Path(name))
        assert site is not None
        browser = launch(driver, "chromium")
        page = site / "physics" / "map.html"
        opened = [_open(browser, page) for _ in range(OPENINGS)]
        browser.close()
    moves = sorted(move for _, _, moved in opened for move in moved)
    return [
        _row("map opened, numpy loaded on the way", [whole for whole, _, _ in opened], None),
        _row("map of 181 × 201 drawn, numpy loaded", [first for _, first, _ in opened], 1_000),
        _row("slider to picture of all points, p50", moves, None),
        _row("slider to picture of all points, p95", [moves[int(0.95 * len(moves))]], 100),
        {
            **_row("pair outcome in Pyodide, over a batch, drawn", moves, 2),
            "value": 1e3 * statistics.median(moves) / POINTS,
            "unit": "µs",
        },
    ]


def _open(browser: Browser, page_file: Path) -> tuple[float, float, list[float]]:
    """From the button to the picture; the part of it after numpy was there; moves of a slider."""
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.goto(page_file.as_uri())
    page.evaluate("document.querySelector('carts-scene').ready")
    whole = page.locator(MAP).evaluate(
        """async (el) => {
            const begun = performance.now();
            await el.open();
            return performance.now() - begun;
        }"""
    )
    page.locator(MAP).evaluate(
        """async (el, moves) => {
            const slider = el.querySelector('[data-set="B.mass"] .carts-slider');
            const [low, high] = [Number(slider.min), Number(slider.max)];
            for (let k = 0; k < moves; k += 1) {
                slider.value = String(low + ((high - low) * ((k * 3) % 10)) / 9);
                slider.dispatchEvent(new Event("input", { bubbles: true }));
                await new Promise((done) => setTimeout(done, 120));
            }
        }""",
        MOVES,
    )
    times = page.evaluate("performance.getEntriesByName('carts:map').map((m) => m.duration)")
    page.close()
    return float(whole), float(times[0]), [float(time) for time in times[1:]]


def _row(name: str, values: list[float], goal: float | None) -> dict[str, Any]:
    reference = "Chromium, file://"
    value = statistics.median(values)
    return {"name": name, "value": value, "unit": "ms", "goal": goal, "reference": reference}
