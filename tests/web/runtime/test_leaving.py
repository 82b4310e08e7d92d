"""A page that is left while it still loads is not a broken page: no complaint, no second start."""

from __future__ import annotations

import functools
import http.server
import threading
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.scene.given.widget_site import LIVE, widget_site

pytestmark = pytest.mark.browser

__all__ = ["widget_site"]  # a fixture


@dataclass
class Slow:
    """A server that holds back Python's memory until it is told to go on, then refuses it once."""

    address: str = ""
    asked: threading.Event = field(default_factory=threading.Event)
    go_on: threading.Event = field(default_factory=threading.Event)


@pytest.fixture
def slow(widget_site: Path) -> Iterator[Slow]:
    state = Slow()

    class Handler(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_: object) -> None:
            pass

        def do_GET(self) -> None:
            if "memory.snapshot" in self.path and not state.go_on.is_set():
                state.asked.set()
                state.go_on.wait(timeout=60)
                return  # no answer, as when a browser cancels
            super().do_GET()

    server = http.server.ThreadingHTTPServer(
        ("127.0.0.1", 0), functools.partial(Handler, directory=str(widget_site))
    )
    threading.Thread(target=server.serve_forever, daemon=True).start()
    state.address = f"http://127.0.0.1:{server.server_address[1]}"
    yield state
    state.go_on.set()
    server.shutdown()
    server.server_close()


def test_a_page_that_is_left_complains_of_nothing(open_page: OpenPage, slow: Slow) -> None:
    page = open_page(f"{slow.address}/coasting.html")
    heard: list[str] = []
    page.on("console", lambda m: heard.append(m.text) if m.type in ("error", "warning") else None)
    assert slow.asked.wait(timeout=60)
    page.goto(f"{slow.address}/words.html", wait_until="commit")
    page.evaluate("1")  # whatever the page before had to say has come before this answer
    assert heard == []


def test_a_page_that_stays_after_all_loads_what_was_cancelled(
    open_page: OpenPage, slow: Slow
) -> None:
    page = open_page(f"{slow.address}/coasting.html")
    heard: list[str] = []
    page.on("console", lambda m: heard.append(m.text) if "plain way" in m.text else None)
    assert slow.asked.wait(timeout=60)
    page.evaluate("dispatchEvent(new Event('beforeunload'))")  # as when a file is downloaded
    slow.go_on.set()
    expect(page.locator("#coasting")).to_have_attribute("data-state", "live", timeout=LIVE)
    assert heard == []
