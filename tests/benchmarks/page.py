"""What a reader waits for: the first picture, Play, a dragged slider; and what a page weighs.

Chromium, from file://, a fresh profile each time, on the site as `make site` builds it. The times
are medians of several openings in one run; they depend on the machine and on what else it does.
"""

from __future__ import annotations

import gzip
import statistics
import tempfile
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, Page, sync_playwright

from sim.cli.site.build import build_site
from tests.web.conftest import launch

ROOT = Path(__file__).parents[2]
OPENINGS = 7
MOVES = 80
LESSON = Path("worksheets") / "newtons-first-law.html"

WATCH = """
window.__shift = 0;
new PerformanceObserver((list) => {
  for (const entry of list.getEntries()) if (!entry.hadRecentInput) window.__shift += entry.value;
}).observe({ type: "layout-shift", buffered: true });
const seen = setInterval(() => {
  const scene = document.querySelector("carts-scene");
  const play = scene && scene.querySelector("button.carts-play");
  if (!play || performance.getEntriesByName("carts:still").length === 0) return;
  clearInterval(seen);
  play.click();
  const moving = setInterval(() => {
    if (scene.time === 0) return;
    window.__playing = performance.now();
    clearInterval(moving);
    play.click();
  }, 1);
}, 1);
"""


def rows() -> list[dict[str, Any]]:
    """One row per goal of the page."""
    with tempfile.TemporaryDirectory() as name, sync_playwright() as driver:
        site = build_site(ROOT, hosted=False, strict=True, site_dir=Path(name))
        assert site is not None
        browser = launch(driver, "chromium")
        opened = [_open(browser, site / "index.html") for _ in range(OPENINGS)]
        updates = _drag(browser, site / "index.html")
        browser.close()
        return [
            _row("carts:still after navigation start", _median(opened, "still"), "ms", 300),
            _row("Play answers after navigation start", _median(opened, "playing"), "ms", 500),
            _row("carts:live after navigation start", _median(opened, "live"), "ms", None),
            _row("layout shift until live", max(o["shift"] for o in opened), "CLS", 0.01),
            _row("slider to picture, two carts, p50", statistics.median(updates), "ms", 16),
            _row("slider to picture, two carts, p95", _percentile(updates, 95), "ms", 33),
            _row("lesson page without runtime, gzip", _weight(site) / 1000, "kB", 450),
            _row("lesson HTML per scene", _html_per_scene(site) / 1000, "kB", 60),
        ]


def _open(browser: Browser, page_file: Path) -> dict[str, float]:
    context = browser.new_context(viewport={"width": 1280, "height": 800})
    page = context.new_page()
    page.add_init_script(WATCH)
    page.goto(page_file.as_uri())
    page.evaluate("document.querySelector('carts-scene').ready")
    found = {
        "still": _mark(page, "carts:still"),
        "live": _mark(page, "carts:live"),
        "playing": float(page.evaluate("window.__playing")),
        "shift": float(page.evaluate("window.__shift")),
    }
    context.close()
    return found


def _mark(page: Page, name: str) -> float:
    return float(page.evaluate(f"performance.getEntriesByName('{name}')[0].startTime"))


def _drag(browser: Browser, page_file: Path) -> list[float]:
    """Durations of carts:update while a slider is dragged."""
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.goto(page_file.as_uri())
    page.evaluate("document.querySelector('carts-scene').ready")
    page.evaluate(
        """async (moves) => {
            const slider = document.querySelector("carts-scene input.carts-slider");
            const [low, high] = [Number(slider.min), Number(slider.max)];
            for (let k = 0; k < moves; k += 1) {
                slider.value = String(low + ((high - low) * ((k * 7) % 30)) / 30);
                slider.dispatchEvent(new Event("input", { bubbles: true }));
                await new Promise((done) => setTimeout(done, 60));
            }
        }""",
        MOVES,
    )
    return [float(d) for d in page.evaluate(
        "performance.getEntriesByName('carts:update').map((m) => m.duration)")]  # fmt: skip


def _weight(site: Path) -> int:
    """Bytes of the lesson with everything it loads but the runtime, each file gzipped."""
    import re

    page = site / LESSON
    html = page.read_text(encoding="utf-8")
    names = set(re.findall(r'(?:src|href)="([^"#?:]+\.(?:js|css|woff2))"', html))
    files = [page, *{(page.parent / name).resolve() for name in names}]
    for sheet in [file for file in files if file.suffix == ".css"]:
        inner = re.findall(r"url\(\"?([^)\"#?:]+\.woff2)\"?\)", sheet.read_text(encoding="utf-8"))
        files += [(sheet.parent / name).resolve() for name in inner]
    return sum(len(gzip.compress(file.read_bytes(), 6)) for file in set(files) if file.is_file())


def _html_per_scene(site: Path) -> float:
    html = (site / LESSON).read_text(encoding="utf-8")
    return len(html.encode()) / html.count("<carts-scene")


def _median(opened: list[dict[str, float]], key: str) -> float:
    return statistics.median(o[key] for o in opened)


def _percentile(values: list[float], percent: float) -> float:
    return sorted(values)[min(len(values) - 1, round(len(values) * percent / 100))]


def _row(name: str, value: float, unit: str, goal: float | None) -> dict[str, Any]:
    reference = "Chromium, file://, fresh profile"
    return {"name": name, "value": value, "unit": unit, "goal": goal, "reference": reference}
