"""Classes: how long it takes to read them and to report, on the command line and in the page.

Files of 50 kB: 24 choices and two texts. Times of the command line are those of a process of its
own, with start and imports; times of the page begin when Python is live.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from playwright.sync_api import expect, sync_playwright

from sim.classroom.files.reading import Source
from sim.pages.runtime import CLASSROOM, default_cache, pack
from tests.benchmarks.page import ROOT
from tests.classroom.given.makers import bank, keys, random_class, sources
from tests.web.classroom.class_site import PAGE
from tests.web.conftest import CONTEXT, launch
from tests.web.runtime.boot_site import bundle

FROM = """() => document.querySelector(".carts-class-files").addEventListener(
  "change", () => performance.mark("from"), { once: true, capture: true })"""
TIMES = """() => {
  const at = (name) => performance.getEntriesByName(name).pop().startTime;
  return ["carts:class-means", "carts:class-done"].map((name) => at(name) - at("from"));
}"""
BANK = bank(24, words=2)


def rows() -> list[dict[str, Any]]:
    """One row per goal."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        made = [*_natively(folder, 300, 3.0), *_natively(folder, 5_000, 20.0)]
        return [*made, *_in_the_page(folder)]


def large_class(count: int) -> list[Source]:
    """`count` files of 50 kB as the page writes them: with the text of every question in them."""
    files = []
    for file in random_class(BANK, count // 2):
        for item in file["items"]:
            item["asked"] = f"What is the force on {item['id']} by the other cart, and why? " * 20
            item["said"] = "Look at both arrows, and at what each of them acts on. " * 10
            if item["type"] == "long":
                item["value"] += " It is the force on the cart by the other one." * 20
        files.append(file)
    return sources(files)


def write_class(place: Path, count: int) -> None:
    """The files and their key in a folder of their own."""
    place.mkdir()
    for file in large_class(count):
        (place / file.name).write_bytes(file.content)
    (place / "key.json").write_text(keys(BANK), encoding="utf-8")


def _natively(folder: Path, count: int, goal: float) -> list[dict[str, Any]]:
    place = folder / str(count)
    # In a process of its own: a child's peak of memory is never below that of its parent.
    make = f"import tests.benchmarks.classroom as c; c.write_class(c.Path({str(place)!r}), {count})"
    subprocess.run([sys.executable, "-c", make], check=True, cwd=ROOT)
    size = sum(path.stat().st_size for path in place.iterdir()) / count / 1000
    start = time.perf_counter()
    words = [sys.executable, "-m", "sim", "class", str(place), "--json"]
    with subprocess.Popen(words, stdout=subprocess.PIPE, cwd=ROOT) as running:
        counted = json.loads((running.stdout or sys.stdin).read())["files"]["counted"]
        _, _, used = os.wait4(running.pid, 0)
        running.returncode = 0
    took = time.perf_counter() - start
    what = f"{counted} files of {size:.0f} kB, carts class"
    made = [_row(what, took, "s", goal)]
    if count > 1_000:
        made.append(_row(f"{what}, memory", used.ru_maxrss / 1024, "MB", 500))
    return made


def _in_the_page(folder: Path) -> list[dict[str, Any]]:
    site = folder / "site"
    assets = site / "assets" / "carts"
    assets.mkdir(parents=True)
    packages = frozenset({"numpy", "scipy", CLASSROOM})
    pack(site, packages=packages, cache=default_cache(ROOT), report=lambda _: None)
    bundle(ROOT / "sim" / "web" / "src" / "class-main.js", assets / "class.js")
    (assets / "carts.css").write_bytes(b"")
    (site / "class.html").write_text(PAGE, encoding="utf-8")
    files = [str(path) for path in sorted((folder / "300").iterdir())]
    made = []
    with sync_playwright() as driver:
        for name in ("chromium", "firefox"):
            browser = launch(driver, name)
            page = browser.new_context(**CONTEXT[name]).new_page()
            page.goto((site / "class.html").as_uri())
            box, state = page.locator(".carts-class-files").first, page.locator("carts-class")
            box.set_input_files(files[:1])
            expect(state).to_have_attribute("data-state", "complete", timeout=120_000)
            page.get_by_role("button", name="Delete everything").click()
            page.get_by_role("button", name="Delete", exact=True).click()
            page.evaluate(FROM)
            box.set_input_files(files)
            status = page.locator(".carts-class-status")
            expect(status).to_have_text(re.compile(r"^30\d files read in"), timeout=120_000)
            first, whole = page.evaluate(TIMES)
            made.append(_row(f"300 files in the page, first means, {name}", first / 1000, "s", 2))
            made.append(_row(f"300 files in the page, all read, {name}", whole / 1000, "s", 8))
            browser.close()
    return made


def _row(name: str, value: float, unit: str, goal: float) -> dict[str, Any]:
    return {"name": name, "value": value, "unit": unit, "goal": goal, "reference": "one run"}
