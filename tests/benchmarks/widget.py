"""What a reader feels: even frames while carts play, a slider that follows the finger, memory.

Chromium, from file://, on the site as `make site` builds it. Frames and times depend on the machine
and on what else it does; memory is the resident size of the page's process.
"""

from __future__ import annotations

import re
import tempfile
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, Page, sync_playwright

from sim.cli.site.build import build_site
from tests.benchmarks.page import _percentile, _row
from tests.web.conftest import launch

ROOT = Path(__file__).parents[2]
PLAYED, EIGHT = "index.html", "sandbox.html"
"""A scene that plays at once: in lessons each waits for its prediction. And eight carts."""
MOVES = 60
SCENES = 6
RANDOM_USE = 120_000
"""ms of random use; the goal is for ten minutes, so this is a part of it."""

FRAMES = """async (seconds) => {
  const scene = document.querySelector("carts-scene:not(:has(.carts-predict))");
  scene.scrollIntoView();
  const stamps = [];
  const collect = (now) => { stamps.push(now); frame = requestAnimationFrame(collect); };
  scene.querySelector(".carts-play").click();
  let frame = requestAnimationFrame(collect);
  await new Promise((done) => setTimeout(done, seconds * 1000));
  cancelAnimationFrame(frame);
  scene.querySelector(".carts-play").click();
  return stamps.slice(1).map((now, k) => now - stamps[k]).slice(5);
}"""
DRAG = """async ([id, moves]) => {
  performance.clearMeasures("carts:update");
  const slider = document.getElementById(id).querySelector("input.carts-slider");
  const [low, high] = [Number(slider.min), Number(slider.max)];
  for (let k = 0; k < moves; k += 1) {
    slider.value = String(low + ((high - low) * ((k * 7) % 30)) / 30);
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    await new Promise((done) => setTimeout(done, 80));
  }
  return performance.getEntriesByName("carts:update").map((m) => m.duration);
}"""
LONG_TASKS = """
window.__long = [];
new PerformanceObserver((list) => {
  window.__long.push(...list.getEntries().map(({ startTime, duration }) => [startTime, duration]));
}).observe({ type: "longtask", buffered: true });
"""
USE = """async (forMs) => {
  const all = [...document.querySelectorAll("carts-scene input.carts-slider:enabled")];
  const end = performance.now() + forMs;
  let seed = 7;
  const dice = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  while (performance.now() < end) {
    const slider = all[Math.floor(dice() * all.length)];
    const [low, high] = [Number(slider.min), Number(slider.max)];
    slider.value = String(low + (high - low) * dice());
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    const play = slider.closest("carts-scene").querySelector(".carts-play");
    if (dice() < 0.2) play.click();
    await new Promise((done) => setTimeout(done, 50));
  }
}"""


def rows() -> list[dict[str, Any]]:
    """One row per goal of the widget."""
    with tempfile.TemporaryDirectory() as name, sync_playwright() as driver:
        site = build_site(ROOT, hosted=False, strict=True, site_dir=Path(name))
        assert site is not None
        browser = launch(driver, "chromium")
        played = _open(browser, site / PLAYED)
        frames = played.evaluate(FRAMES, 8)
        tasks = [d for start, d in played.evaluate("window.__long") if start > _live(played)]
        played.close()  # it may play on
        eight = _open(browser, site / EIGHT)
        updates = eight.evaluate(DRAG, ["sandbox-eight", MOVES])
        one, six = _boot(browser, site, 1), _boot(browser, site, SCENES)
        with_scene, growth = _memory(browser, site)
        without = _without(browser, site)
        browser.close()
    return [
        _row("frame interval while playing, p95", _percentile(frames, 95), "ms", 17),
        _row("frame interval while playing, p99", _percentile(frames, 99), "ms", 20),
        _row("frame interval while playing, worst", max(frames), "ms", 50),
        _row("longest task after the page is live", max(tasks, default=0.0), "ms", 50),
        _row("slider to picture, eight carts, p95", _percentile(updates, 95), "ms", 50),
        _row(f"{SCENES} scenes live, against one", six / one, "", 1.5),
        _row("memory over a page without scenes", with_scene - without, "MB", 150),
        _row("growth in two minutes of random use", growth, "MB", 5),
    ]


def _open(browser: Browser, path: Path) -> Page:
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.add_init_script(LONG_TASKS)
    page.goto(path.as_uri())
    page.evaluate("Promise.all([...document.querySelectorAll('carts-scene')].map((s) => s.ready))")
    return page


def _live(page: Page) -> float:
    found = page.evaluate("performance.getEntriesByName('carts:live').map((m) => m.startTime)")
    return float(max(found))


def _boot(browser: Browser, site: Path, count: int) -> float:
    """ms until `count` scenes of one page are live; the best of three openings."""
    page = (site / "index.html").read_text(encoding="utf-8")
    found = re.search(r"<carts-scene.*?</carts-scene>", page, re.DOTALL)
    assert found is not None
    scene, name = found[0], re.search(r'id="([^"]+)"', found[0])
    assert name is not None
    many = "".join(scene.replace(name[1], f"{name[1]}-{k}") for k in range(count))
    path = site / f"scenes-{count}.html"
    path.write_text(page.replace(scene, many), encoding="utf-8")
    times = []
    for _ in range(3):
        opened = _open(browser, path)
        times.append(_live(opened))
        opened.close()
    return min(times)


def _resident(browser: Browser) -> float:
    """MB of the largest page process."""
    session = browser.new_browser_cdp_session()
    listed = session.send("SystemInfo.getProcessInfo")["processInfo"]
    sizes = [0.0]
    for process in listed:
        if process["type"] == "renderer":
            text = Path(f"/proc/{process['id']}/status").read_text(encoding="utf-8")
            sizes.append(int(text.split("VmRSS:")[1].split()[0]) / 1000)
    session.detach()
    return max(sizes)


def _memory(browser: Browser, site: Path) -> tuple[float, float]:
    """MB: of the home page once live; its growth in random use, for ten minutes."""
    for page in [page for context in browser.contexts for page in context.pages]:
        page.close()
    page = _open(browser, site / "index.html")
    live = _at_rest(browser, page)
    page.evaluate(USE, RANDOM_USE / 4)  # caches fill
    before = _at_rest(browser, page)
    page.evaluate(USE, RANDOM_USE)
    growth = _at_rest(browser, page) - before
    page.close()
    return live, growth


def _at_rest(browser: Browser, page: Page) -> float:
    """MB, once what is not needed is gone."""
    session = page.context.new_cdp_session(page)
    for _ in range(3):
        page.wait_for_timeout(1000)
        session.send("HeapProfiler.collectGarbage")
    session.detach()
    return _resident(browser)


def _without(browser: Browser, site: Path) -> float:
    """MB of the same page without its scripts of ours."""
    text = (site / "index.html").read_text(encoding="utf-8")
    path = site / "bare.html"
    path.write_text(re.sub(r'<script src="[^"]*carts\.js"></script>', "", text), encoding="utf-8")
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.goto(path.as_uri())
    found = _at_rest(browser, page)
    page.close()
    return found
