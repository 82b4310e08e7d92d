"""Answers: how soon they are kept, whether a killed browser loses one, how soon a form can be used.

From file://, on a page of questions without any scene. CARTS_KILLS (50) is the number of kills for
each browser, 50 ms after the last key, CARTS_VISITS (50) that of visits which type before the store
is open.
"""

from __future__ import annotations

import os
import statistics
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, Playwright, sync_playwright

from tests.browsers.killed_webkit import has_webkit, lost_in_webkit
from tests.web.conftest import CONTEXT, launch
from tests.web.question.early_typing import LATEST, lost_earlier
from tests.web.question.killed_browser import lost_answers
from tests.web.question.question_site import ALL_KINDS, prepare, ready, write_page

KEYS = 120
OPENINGS = 7
KILLED_AFTER = 0.05  # s after the last key; what is shorter, no store promises
SAVE_TIMES = """async (keys) => {
  const box = document.querySelector("#why textarea");
  const told = document.querySelector("#why .carts-q-saved");
  const times = [];
  for (let k = 0; k < keys; k += 1) {
    const start = performance.now();
    box.value += "x";
    box.dispatchEvent(new Event("input", { bubbles: true }));
    while (told.textContent !== "Saved") await new Promise((resolve) => {
      const channel = new MessageChannel();
      channel.port1.onmessage = resolve;
      channel.port2.postMessage(0);
    });
    times.push(performance.now() - start);
  }
  return times;
}"""


def rows() -> Iterator[dict[str, Any]]:
    """One row per goal, for each browser, as soon as it is measured: many kills take hours."""
    with tempfile.TemporaryDirectory() as name, sync_playwright() as driver:
        site = prepare(Path(name) / "site")
        kinds = write_page(site, "kinds", ALL_KINDS)
        form = write_page(site, "sixty", sixty())
        for browser_name in ("chromium", "firefox"):
            browser = launch(driver, browser_name)
            yield _save(browser, browser_name, kinds)
            yield _interactive(browser, browser_name, form)
            yield _early(browser, browser_name, kinds)
            browser.close()
            yield _kills(driver, browser_name, Path(name) / browser_name, kinds)
        if has_webkit():
            yield _kills_of_webkit(Path(name) / "webkit", kinds)


def sixty() -> str:
    """A lesson of sixty single choices with four answers each."""
    block = (
        "```question\nid: item-{k}\ntype: single\nask: Question number {k} about a force?\n"
        "options: [first {k}, second {k}, third {k}, {{text: fourth, correct: true}}]\n```\n\n"
    )
    return "".join(block.format(k=k) for k in range(60))


def _save(browser: Browser, name: str, file: Path) -> dict[str, Any]:
    page = browser.new_context(**CONTEXT[name]).new_page()
    page.goto(file.as_uri())
    times = sorted(ready(page).evaluate(SAVE_TIMES, KEYS))
    p95 = times[int(0.95 * len(times))]
    return _row(f"input to durable save, p95, {name}", p95, "ms", 50, f"{KEYS} keys")


def _interactive(browser: Browser, name: str, file: Path) -> dict[str, Any]:
    times = []
    for _ in range(OPENINGS):
        context = browser.new_context(**CONTEXT[name])
        page = context.new_page()
        page.goto(file.as_uri())
        ready(page)
        mark = "performance.getEntriesByName('carts:answers')[0].startTime"
        times.append(page.evaluate(mark))
        context.close()
    what = f"a form of 60 items can be used, {name}"
    return _row(what, statistics.median(times), "ms", 300, f"median of {OPENINGS} fresh profiles")


def _early(browser: Browser, name: str, file: Path) -> dict[str, Any]:
    visits = int(os.environ.get("CARTS_VISITS", "50"))
    lost = lost_earlier(browser, name, file, visits, seed=6)
    what = f"earlier answers lost by typing before the store is open, {name}"
    return _row(what, len(lost), "", 0, f"{visits} visits, store 0 to {LATEST:.0f} s late")


def _kills(driver: Playwright, name: str, profile: Path, file: Path) -> dict[str, Any]:
    delays = _delays()
    lost = lost_answers(driver, name, profile, file, delays, told=False)
    return _killed(name, lost, delays)


def _kills_of_webkit(profile: Path, file: Path) -> dict[str, Any]:
    profile.mkdir()
    delays = _delays()
    return _killed("webkit", lost_in_webkit(profile, file, delays), delays)


def _delays() -> list[float]:
    return [KILLED_AFTER] * int(os.environ.get("CARTS_KILLS", "50"))


def _killed(name: str, lost: list[str], delays: list[float]) -> dict[str, Any]:
    for line in lost:
        print(f"lost by {name}: {line}", file=sys.stderr, flush=True)
    what = f"answers lost to a killed browser, {name}"
    return _row(what, len(lost), "", 0, f"{len(delays)} kills, 50 ms after the last key")


def _row(name: str, value: float, unit: str, goal: float, reference: str) -> dict[str, Any]:
    return {"name": name, "value": value, "unit": unit, "goal": goal, "reference": reference}
