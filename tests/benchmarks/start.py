"""Where the time of Python's start goes: step by step, of a page without packages, one with numpy.

The steps overlap: files come and are decoded in the page, machine code is compiled and files are
unpacked beside it, Python's worker waits for both. A row says when a step was over, in parts of the
whole; its unit says from when to when, in ms since the page was asked for.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, sync_playwright

from tests.benchmarks._rows import Row
from tests.web.conftest import CONTEXT, launch
from tests.web.runtime.boot_site import build_site, write_page

ONLY_ASKED = True
RUNS = 7  # the quickest is shown: whatever else the computer does only makes a start slower
SPY = (Path(__file__).parent / "_start.js").read_text(encoding="utf-8")

Step = tuple[str, float, float]

NAMES = {
    "script": "files come, as scripts",
    "base64": "… of that: decoded (sum)",
    "sha256": "… of that: checked (sum)",
    "compile": "machine code is compiled while it comes",
    "worker": "the workers run",
    "unpacked": "files are unpacked beside the page",
    "instance": "an instance of the machine code",
    "progress python": "Python's memory is there, Python lives",
    "library": "… of that: instances of numpy's libraries (sum)",
    "progress packages": "packages are unpacked and loaded",
    "progress numpy": "numpy is imported",
    "ready": "our modules are imported",
    "answer": "the first answer",
}
SUMS = ("base64", "sha256", "library")
AFTER = ("progress python", "progress packages", "progress numpy", "ready", "answer")
"""One after another in Python's worker: each begins where the one before has ended."""


def rows() -> list[Row]:
    """All steps, of both pages in both browsers."""
    with tempfile.TemporaryDirectory() as name, sync_playwright() as driver:
        site = build_site(Path(name), packages=frozenset({"numpy"}))
        pages = {"": site / "index.html"}
        pages["numpy, "] = write_page(site, name="numpy.html", packages="numpy")
        found: list[Row] = []
        for browser_name in ("chromium", "firefox"):
            browser = launch(driver, browser_name)
            for what, page in pages.items():
                runs = [_steps(browser, browser_name, page) for _ in range(RUNS)]
                found += _rows(f"{what}{browser_name}", min(runs, key=_end))
            browser.close()
        return found


def _steps(browser: Browser, browser_name: str, file: Path) -> list[Step]:
    context = browser.new_context(**CONTEXT[browser_name])
    page = context.new_page()
    page.add_init_script(SPY)
    page.goto(file.as_uri())
    result: dict[str, Any] = page.evaluate("window.booted")
    assert result.get("start") == "snapshot", result
    steps: list[Step] = page.evaluate("window.steps")
    context.close()
    return steps


def _end(steps: list[Step]) -> float:
    return max(end for name, _, end in steps if name == "answer")


def _rows(where: str, steps: list[Step]) -> list[Row]:
    whole, before = _end(steps), 0.0
    lives = max(end for name, _, end in steps if name == "progress python")
    spans: dict[str, list[tuple[float, float]]] = {}
    for name, begin, end in steps:
        key = "library" if name == "instance" and begin > lives else name
        spans.setdefault(key, []).append((begin, end))
    found = []
    for key in filter(spans.__contains__, NAMES):
        begin, end = min(spans[key])[0], max(end for _, end in spans[key])
        unit, part = f"{begin:.0f} to {end:.0f} ms", end / whole
        if key in SUMS:
            span = sum(to - at for at, to in spans[key])
            unit, part = f"{span:.0f} ms", span / whole
        elif key in AFTER:
            unit = f"{before:.0f} to {end:.0f} ms"
        if key in ("instance", *AFTER):
            before = end
        found.append(
            {
                "name": f"{where}: {NAMES[key]}", "value": part, "unit": unit, "goal": None,
                "reference": f"{whole:.0f} ms",
            }
        )  # fmt: skip
    return found
