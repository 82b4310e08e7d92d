"""`make fuzz AREA=faults`: every fault in Chromium, as a table; it fails if one is silent."""

from __future__ import annotations

import functools
import http.server
import shutil
import sys
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import quote

from playwright.sync_api import Browser, Page, sync_playwright

from tests.web.conftest import LAUNCH

from .table import Fault, faults

ROOT = Path(__file__).parents[2]
LESSON = "worksheets/newtons-third-law.html"
LEFT_OUT = shutil.ignore_patterns("search", "numpy*", "scipy*")
SETTLED = 25_000  # ms in which Python starts or fails, on a machine that others use too
STEP = 100  # ms between two looks
SOON = 4_000  # ms in which an answer is kept, or the page says that it is not

STATE = "['ready', 'failed'].includes(document.documentElement.dataset.python)"
TOLD = """[...document.querySelectorAll("[role=alert], .carts-note, .carts-bar, .carts-q-saved")]
  .map((note) => note.offsetHeight ? note.textContent.trim() : "")
  .filter((text) => /not|can.t|missing|damaged|too|lost|nothing|Opening/i.test(text)).join(" | ")"""
FIELD = "carts-question textarea:not([readonly], :disabled):visible"
KEPT = """[...document.querySelectorAll("carts-question .carts-q-saved")].some((its) =>
  its.textContent === "Saved")"""


class Quiet(http.server.SimpleHTTPRequestHandler):
    """Tells nobody."""

    def log_message(self, *_: object) -> None:
        pass


@contextmanager
def address(fault: Fault, site: Path) -> Iterator[str]:
    """Where the lesson is opened."""
    if fault.mode == "disk":
        yield f"file://{quote(site.as_posix())}/{LESSON}"
        return
    handler = functools.partial(Quiet, directory=str(site))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_address[1]}/{LESSON}"
        server.shutdown()


def until(page: Page, what: str, patience: int) -> bool:
    """Whether it comes true; the page's policy lets no driver wait inside."""
    for _ in range(patience // STEP):
        if page.evaluate(what):
            return True
        page.wait_for_timeout(STEP)
    return False


def seen(browser: Browser, fault: Fault, where: str) -> tuple[bool, bool, str]:
    """Whether Python lives, whether an answer is kept, and what the page says."""
    context = browser.new_context()
    page = context.new_page()
    if fault.without:
        page.add_init_script(fault.without)
    page.goto(where)
    until(page, f"{STATE} || document.querySelector('.carts-watchdog')", SETTLED)
    live = page.evaluate("document.documentElement.dataset.python") == "ready"
    box = page.locator(FIELD).first
    kept = False
    if page.locator(FIELD).count():
        box.fill("an answer", timeout=SOON)
        kept = until(page, KEPT, SOON)
    told = str(page.evaluate(TOLD))
    context.close()
    return live, kept, told


def tried(browser: Browser, fault: Fault) -> tuple[bool, str]:
    """Whether the fault is silent, and its line."""
    with tempfile.TemporaryDirectory() as folder:
        site = Path(folder) / fault.folder
        for part in ("worksheets", "assets"):
            shutil.copytree(ROOT / "site" / part, site / part, ignore=LEFT_OUT)
        fault.harm(site)
        with address(fault, site) as where:
            live, kept, told = seen(browser, fault, where)
    silent = not (live and kept) and not told
    verdict = "SILENT" if silent else "says so" if not (live and kept) else "works"
    return silent, f"{fault.name:45} {verdict:8} {'live' if live else '-':5} {told[:90]}"


def main() -> None:
    """The table; the number of silent faults is the verdict."""
    silent = total = 0
    with sync_playwright() as driver:
        browser = driver.chromium.launch(**LAUNCH["chromium"])
        for fault in faults():
            one, line = tried(browser, fault)
            silent, total = silent + one, total + 1
            print(line, flush=True)
        browser.close()
    print(f"{total} faults, {silent} silent")
    sys.exit(1 if silent else 0)


main()
