"""A hosted site in browsers: offline after the first visit, one version at a time, in a folder."""

from __future__ import annotations

import functools
import http.server
import os
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect

from sim.pages.offline import Hosting
from tests.web.conftest import CONTEXT

pytestmark = [pytest.mark.browser, pytest.mark.slow]

WAIT = 60_000  # ms
PAGE = """<!doctype html><html lang="en"><head><title>{title}</title>
<script src="{root}assets/carts/part.js"></script></head><body>{title}</body></html>
"""


class Server:
    """A web server that can be switched off; the site lies in a folder of it."""

    def __init__(self, folder: Path) -> None:
        class Quiet(http.server.SimpleHTTPRequestHandler):
            def log_message(self, *_: object) -> None:
                pass

            def end_headers(self) -> None:
                self.send_header("Cache-Control", "no-cache")  # the browser's own cache stays out
                super().end_headers()

        handler = functools.partial(Quiet, directory=str(folder))
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        self.address = f"http://localhost:{self.server.server_address[1]}/"
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def off(self) -> None:
        self.server.shutdown()
        self.server.server_close()


def publish(folder: Path, version: str, *, offline: bool = True) -> None:
    """A site of two pages and a script, all of one version."""
    hosting = Hosting("Our school", offline=offline)
    for name, root in (("index.md", ""), ("lessons/one.md", "../")):
        path = folder / name.replace(".md", ".html")
        path.parent.mkdir(parents=True, exist_ok=True)
        page = PAGE.format(title=f"{name} {version}", root=root)
        path.write_text(hosting.head(page, name, f"{root}assets/carts/"), encoding="utf-8")
    assets = folder / "assets" / "carts"
    assets.mkdir(parents=True, exist_ok=True)
    (assets / "part.js").write_text(f'document.documentElement.dataset.part = "{version}";')
    (assets / "lessons").mkdir(exist_ok=True)
    (assets / "lessons" / "rare.js").write_text('document.documentElement.dataset.rare = "1";')
    hosting.write(folder, "our-school")
    later = time.time() + 60 * ("first", "second", "third").index(version)
    for path in folder.rglob("*"):  # the server tells versions apart by whole seconds
        os.utime(path, (later, later))


@pytest.fixture
def www(tmp_path: Path) -> Path:
    publish(tmp_path / "school" / "physics", "first")
    (tmp_path / "other.html").write_text("<!doctype html><title>Other</title>", encoding="utf-8")
    return tmp_path


@pytest.fixture
def context(browser: Browser, browser_name: str) -> Iterator[BrowserContext]:
    made = browser.new_context(**CONTEXT[browser_name])
    yield made
    made.close()


PYTHON_KEPT = """async () => {
    const parts = performance.getEntriesByType("resource").map((one) => one.name)
        .filter((name) => name.includes("/runtime/"));
    const found = await Promise.all(parts.map((name) => caches.match(name)));
    return parts.length > 0 && found.every(Boolean);
}"""


REFUSED = """async () => {
    const site = await navigator.serviceWorker.ready;
    await site.update().catch(() => {});
    const coming = site.installing;
    await new Promise((done) => {
        const look = () => (!coming || coming.state === "redundant") && done();
        coming?.addEventListener("statechange", look);
        look();
    });
    if (site.waiting) throw new Error("it was taken");
}"""
"""A new version is looked for, and given up."""


def kept(page: Page, address: str) -> None:
    page.goto(address)
    page.wait_for_selector("html[data-offline=ready]", timeout=WAIT)


def versions(page: Page) -> tuple[str, str]:
    """Those of the page and of its script."""
    return page.title().split()[-1], page.evaluate("document.documentElement.dataset.part")


def test_after_one_visit_every_page_opens_without_a_network(
    www: Path, context: BrowserContext
) -> None:
    server = Server(www)
    home = f"{server.address}school/physics/"
    page = context.new_page()
    kept(page, home)
    page.evaluate("localStorage.setItem('answer', '42')")
    server.off()
    for address in (home, f"{home}index.html", f"{home}lessons/one.html"):
        page.goto(address)
        assert versions(page) == ("first", "first")
    assert page.evaluate("localStorage.getItem('answer')") == "42"
    names = page.evaluate("caches.keys()")
    assert len(names) == 1
    assert "/school/physics/" in names[0]  # other sites of the same host have their own


def test_a_new_version_comes_whole_and_the_old_one_goes(www: Path, context: BrowserContext) -> None:
    server = Server(www)
    home = f"{server.address}school/physics/"
    page = context.new_page()
    kept(page, home)
    page.goto(home)
    assert versions(page) == ("first", "first")
    publish(www / "school" / "physics", "second")
    page.evaluate("navigator.serviceWorker.ready.then((r) => r.update())")
    waiting = "navigator.serviceWorker.ready.then((r) => !!r.waiting)"
    page.wait_for_function(f"() => {waiting}", timeout=WAIT)

    other = context.new_page()  # while a page of the first version is open, the first goes on
    other.goto(f"{home}lessons/one.html")
    assert versions(other) == ("first", "first")
    assert other.evaluate(waiting)
    page.close()
    other.goto(f"{home}lessons/one.html")
    expect(other).to_have_title("lessons/one.md second", timeout=WAIT)
    assert versions(other) == ("second", "second")
    other.wait_for_function("async () => (await caches.keys()).length === 1", timeout=WAIT)
    server.off()
    other.goto(home)
    assert versions(other) == ("second", "second")


def test_a_version_that_cannot_be_had_whole_does_not_count(
    www: Path, context: BrowserContext
) -> None:
    server = Server(www)
    home = f"{server.address}school/physics/"
    page = context.new_page()
    kept(page, home)
    folder = www / "school" / "physics"
    publish(folder, "second")
    (folder / "assets" / "carts" / "part.js").write_text("half a fil")  # while it is being uploaded
    page.evaluate(REFUSED)
    page.goto(home)
    assert versions(page) == ("first", "first")
    server.off()
    page.goto(f"{home}lessons/one.html")
    assert versions(page) == ("first", "first")


def test_a_page_out_of_the_site_and_a_switched_off_site_are_left_alone(
    www: Path, context: BrowserContext
) -> None:
    server = Server(www)
    home = f"{server.address}school/physics/"
    page = context.new_page()
    kept(page, home)
    page.goto(f"{server.address}other.html")
    assert page.title() == "Other"
    assert page.evaluate("navigator.serviceWorker.controller") is None
    publish(www / "school" / "physics", "third", offline=False)
    page.goto(home)
    page.evaluate(
        "navigator.serviceWorker.getRegistration().then((r) => r && r.update()).catch(() => {})"
    )
    page.wait_for_function("async () => (await caches.keys()).length === 0", timeout=WAIT)
    page.goto(home)
    assert versions(page) == ("third", "third")
    server.off()


def test_a_lesson_of_a_hosted_site_is_alive_without_a_network(
    hosted_site: Path, context: BrowserContext, browser_name: str
) -> None:
    if browser_name == "firefox":
        pytest.skip("what is kept is tested above in both; Python starts from it alike")
    server = Server(hosted_site.parents[1])
    home = f"{server.address}school/p/"
    page = context.new_page()
    kept(page, f"{home}worksheets/newtons-third-law.html")
    page.wait_for_selector("carts-scene[data-state=live]", timeout=WAIT)
    page.wait_for_function(PYTHON_KEPT, timeout=WAIT)  # the first visit tells what it has loaded
    server.off()
    context.set_offline(True)
    page.goto(f"{home}worksheets/newtons-first-law.html")
    page.wait_for_selector("carts-scene[data-state=live]", timeout=WAIT)
    page.goto(home)
    assert page.title().startswith("Newton's Carts")


def test_nothing_of_it_is_in_a_site_for_double_click(site: Path) -> None:
    names = {path.name for path in site.rglob("*")}
    assert not names & {"sw.js", "offline.js", "manifest.webmanifest"}
    for page in site.rglob("*.html"):
        text = page.read_text(encoding="utf-8")
        assert "serviceWorker" not in text
        assert 'rel="manifest"' not in text
