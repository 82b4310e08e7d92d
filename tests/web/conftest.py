"""Browsers for the tests that drive pages: Debian's Chromium and Firefox ESR.

Both run as a user's would: strict origins on file:// (Playwright's Firefox has them off, which
hides what users meet), and every request that leaves the site fails the test.
"""

from __future__ import annotations

import functools
import http.server
import os
import shutil
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

import pytest
from playwright.sync_api import Browser, Page, Playwright, Request, expect, sync_playwright

from tests.web.last_words import LastWords
from tests.web.shared_page import WINDOW, SharedPage, Size, parts

LAUNCH: dict[str, dict[str, Any]] = {
    "chromium": {
        "executable_path": "/usr/bin/chromium",
        # root can't use Chromium's sandbox, and /dev/shm is small in containers
        "args": ["--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu"],
    },
    "firefox": {
        "executable_path": "/usr/bin/firefox-esr",
        "channel": "moz-firefox",
        "firefox_user_prefs": {"security.fileuri.strict_origin_policy": True},
    },
}
# The same engine without a desktop's windows around it: a page opens in less than half the time.
LIGHT = Path("/usr/bin/chromium-headless-shell")
# ESR 153 does not know the command that emulates these; "null" means: leave them alone.
UNSET = dict.fromkeys(("color_scheme", "reduced_motion", "forced_colors", "contrast"), "null")
CONTEXT: dict[str, dict[str, Any]] = {"chromium": {}, "firefox": UNSET}

PATIENCE = 20_000
"""ms that a test waits for what it expects of a page. A page that is right comes there sooner; on a
machine that others use too, the five seconds of the driver's own are not always enough."""
expect.set_options(timeout=PATIENCE)

OpenPage = Callable[..., Page]
SharePage = Callable[..., Page]
OPENED = pytest.StashKey[list[LastWords]]()
"""The pages that a test has opened, to be told about where it fails."""


# Python in a page is started some five hundred times here, and seldom computes for long: to compile
# it again for speed, beside what runs, takes a quarter of a start. Benchmarks do without.
BRIEFLY = "--js-flags=--liftoff-only"


def options(name: str, *, briefly: bool = False) -> dict[str, Any]:
    """How a browser starts: Chromium without a desktop's windows where Debian has it so.
    `briefly`: for pages that live a moment."""
    found = dict(LAUNCH[name])
    if name == "chromium":
        found |= {"executable_path": LIGHT} if LIGHT.exists() else {}
        found |= {"args": [*found["args"], BRIEFLY]} if briefly else {}
    return found


def launch(driver: Playwright, name: str, *, briefly: bool = False) -> Browser:
    """Start a browser by name, as `options` says."""
    return getattr(driver, name).launch(**options(name, briefly=briefly))


_drivers: list[Playwright] = []  # at most one: a second in the same process refuses to start
_running: dict[tuple[str, bool], Browser] = {}
"""The browsers that run, by name and whether for pages that live a moment. Each is started once and
stays for the files to come (started anew for every file Chromium costs a second, Firefox three)."""


@pytest.fixture(scope="session")
def driver() -> Iterator[Playwright]:
    """Other folders of tests take this fixture over: whoever is first starts it for all."""
    if _drivers:
        yield _drivers[0]
        return
    with sync_playwright() as started:
        _drivers.append(started)
        yield started
        for running in _running.values():
            running.close()
        _running.clear()
        _drivers.clear()


@pytest.fixture(scope="session", params=["chromium", "firefox"])
def browser_name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture(scope="session")
def browser(driver: Playwright, browser_name: str) -> Browser:
    return running(driver, browser_name, briefly=True)


def running(driver: Playwright, name: str, *, briefly: bool) -> Browser:
    """The browser that runs already, or one that is started and stays."""
    if not Path(LAUNCH[name]["executable_path"]).exists():
        pytest.fail(f"{name} is not installed: run `make browsers`")
    key = (name, briefly and name == "chromium")
    if key not in _running or not _running[key].is_connected():
        _running[key] = launch(driver, name, briefly=briefly)
    return _running[key]


@pytest.fixture
def open_page(
    browser: Browser, browser_name: str, request: pytest.FixtureRequest
) -> Iterator[OpenPage]:
    """Return `open_page(where, **context)`: `where` is a file (opened by file://) or an address.

    `folder` is the site's folder, by default that of the file. A new profile for every page. Any
    request outside the folder or the origin fails the test at its end.
    """
    with _opening(browser, browser_name, request.node) as open_it:
        yield open_it


@pytest.fixture(scope="module")
def open_for_all(
    browser: Browser, browser_name: str, request: pytest.FixtureRequest
) -> Iterator[OpenPage]:
    """The same for a page that all tests of a file have, and only look at."""
    with _opening(browser, browser_name, request.node) as open_it:
        yield open_it


@pytest.fixture(scope="module")
def _shared(open_for_all: OpenPage) -> Callable[[Path], SharedPage]:
    kept: dict[tuple[Path, tuple[str, str]], SharedPage] = {}

    def of(file: Path) -> SharedPage:
        key = file.parent, parts(file)[0]
        if key not in kept:
            copy = file.with_name(f"shared-{os.getpid()}-{len(kept)}.html")
            shutil.copyfile(file, copy)
            kept[key] = SharedPage(open_for_all(copy), copy)
        return kept[key]

    return of


@pytest.fixture
def shared_page(
    _shared: Callable[[Path], SharedPage], request: pytest.FixtureRequest
) -> Iterator[SharePage]:
    """Return `shared_page(file, window=WINDOW)`: a page that the tests of a file of tests have one
    after another, as it was when it came, with Python running (`tests/web/shared_page.py`)."""
    used: list[SharedPage] = []

    def begin(file: Path, window: Size = WINDOW) -> Page:
        used.append(_shared(file))
        request.node.stash.setdefault(OPENED, []).append(used[-1].words)
        return used[-1].begin(file, window)

    yield begin
    for one in used:
        one.end()


@contextmanager
def _opening(browser: Browser, browser_name: str, node: pytest.Item) -> Iterator[OpenPage]:
    outside: list[str] = []
    contexts = []

    def open_it(where: Path | str, *, folder: Path | None = None, **context: Any) -> Page:
        made = browser.new_context(**CONTEXT[browser_name], **context)
        contexts.append(made)
        page = made.new_page()
        node.stash.setdefault(OPENED, []).append(LastWords(page))
        if isinstance(where, Path):
            home = (folder or where.parent).resolve().as_posix() + "/"
            address = where.resolve().as_uri()
        else:
            home, address = "/", where

        def check(asked: Request) -> None:
            if not is_inside(asked.url, address, home):
                outside.append(asked.url)

        made.on("request", check)
        page.goto(address)
        return page

    yield open_it
    for made in contexts:
        made.close()
    assert not outside, f"requests outside the site: {outside}"


def is_inside(url: str, address: str, home: str) -> bool:
    """Whether `url` stays in folder `home` (a path with a slash at its end) of `address`."""
    asked, own = urlsplit(url), urlsplit(address)
    if asked.scheme in {"blob", "data", "about"}:
        return True
    path = os.path.normpath(unquote(asked.path))
    return (asked.scheme, asked.netloc) == (own.scheme, own.netloc) and path.startswith(home)


class _Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_: object) -> None:
        pass


@pytest.fixture(scope="session")
def site_server() -> Iterator[Callable[[Path], str]]:
    """Return `site_server(folder)`, which serves a folder and returns its address."""
    servers = []

    def serve(folder: Path) -> str:
        handler = functools.partial(_Quiet, directory=str(folder))
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        servers.append(server)
        return f"http://127.0.0.1:{server.server_address[1]}"

    yield serve
    for server in servers:
        server.shutdown()
        server.server_close()
