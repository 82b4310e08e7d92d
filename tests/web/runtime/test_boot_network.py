"""Python over a network that drops requests, or is slow: it is asked again, and waited for."""

from __future__ import annotations

import functools
import http.server
import threading
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.web.conftest import OpenPage
from tests.web.runtime.boot_site import write_page
from tests.web.runtime.booted import HURRIED, HURRY, TOLD_WITHIN, booted
from tests.web.scene.given.widget_site import LIVE, widget_site

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]

__all__ = ["widget_site"]  # a fixture

HELD = 6.0  # s; longer than the page is told to wait for what does not come over a network
PATIENCE = '<script src="patience.js"></script>'


@dataclass
class Network:
    """Serves a site; `drops`: how often a file whose name holds these letters does not come."""

    address: str = ""
    drops: dict[str, int] = field(default_factory=dict)
    cuts: dict[str, int] = field(default_factory=dict)  # the same, of one that ends in its middle
    held: str = ""  # a file that comes later by as many seconds
    seconds: float = HELD
    late: float = 0.0  # s by which every file of the runtime comes later
    asked: Counter[str] = field(default_factory=Counter)
    under_way: int = 0
    most: int = 0
    lock: threading.Lock = field(default_factory=threading.Lock)

    def wait(self, name: str) -> None:
        """Counted as under way until the first byte goes: a page that has the last may ask on."""
        with self.lock:
            self.asked[name] += 1
            self.under_way += 1
            self.most = max(self.most, self.under_way)
        time.sleep(self.seconds if self.held and self.held in name else self.late)
        with self.lock:
            self.under_way -= 1

    def is_among(self, those: dict[str, int], name: str) -> bool:
        return any(part in name and self.asked[name] <= n for part, n in those.items())


@contextmanager
def serving(folder: Path) -> Iterator[Network]:
    state = Network()

    class Handler(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_: object) -> None:
            pass

        def do_GET(self) -> None:
            name = self.path.rpartition("/")[2].partition("?")[0]
            if "/runtime/" not in self.path:
                super().do_GET()
                return
            state.wait(name)
            if state.is_among(state.drops, name):
                self.send_error(503)
            elif state.is_among(state.cuts, name):
                self.half()
            else:
                super().do_GET()

        def half(self) -> None:
            """The first half of a file, as if that were all of it."""
            whole = Path(self.translate_path(self.path)).read_bytes()
            self.send_response(200)
            self.send_header("Content-Type", "text/javascript")
            self.send_header("Cache-Control", "max-age=3600")
            self.end_headers()
            self.wfile.write(whole[: len(whole) // 2])

    made = functools.partial(Handler, directory=str(folder))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), made) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        state.address = f"http://127.0.0.1:{server.server_address[1]}"
        yield state
        server.shutdown()


@pytest.fixture
def network(boot_site: Path) -> Iterator[Network]:
    with serving(boot_site) as state:
        yield state


def test_a_request_that_was_dropped_is_made_again(open_page: OpenPage, network: Network) -> None:
    network.drops = {"index.js": 1, "pyodide.asm.wasm": 1}
    result = booted(open_page(f"{network.address}/index.html"))
    assert result.get("start") == "snapshot", result
    assert network.asked["index.js"] == 2


def test_a_file_that_a_network_cut_short_is_asked_for_again(
    open_page: OpenPage, network: Network
) -> None:
    """By another address: a cache on the way has the half of it."""
    network.cuts = {"pyodide.asm.wasm": 1, "python.zip": 1}
    result = booted(open_page(f"{network.address}/index.html"))
    assert result.get("start") == "snapshot", result


def test_a_file_that_stays_damaged_is_told_in_words_for_the_web(
    open_page: OpenPage, network: Network
) -> None:
    network.cuts = {"pyodide.asm.wasm": 99}
    result = booted(open_page(f"{network.address}/index.html"))
    assert result["reason"] == "payload-damaged"
    assert "load the page again" in result["message"]


def test_what_never_comes_is_told_in_words_for_the_web(
    open_page: OpenPage, network: Network
) -> None:
    network.drops = {"pyodide.asm.wasm": 99}
    result = booted(open_page(f"{network.address}/index.html"))
    assert result["reason"] == "payload-missing"
    assert "load the page again" in result["message"] and "folder" not in result["message"]
    assert result["waited"] < TOLD_WITHIN


def test_two_files_at_most_are_under_way(open_page: OpenPage, network: Network) -> None:
    """Six that share a slow line are all late; the first of two is there soon."""
    network.late = 0.1
    assert booted(open_page(f"{network.address}/index.html"))["start"] == "snapshot"
    assert sum(network.asked.values()) > 4
    assert network.most == 2


def test_a_slow_network_is_told_and_waited_for(
    open_page: OpenPage, network: Network, boot_site: Path
) -> None:
    (boot_site / "patience.js").write_text(f"{HURRIED}window.bootPatience = 4;\n", encoding="utf-8")
    write_page(boot_site, name="patient.html", before=PATIENCE)
    network.held, network.seconds = "pyodide.asm.wasm", HELD / HURRY
    page = open_page(f"{network.address}/patient.html")
    result = booted(page)
    assert result.get("start") == "snapshot", result
    stages = page.evaluate("window.progress.map(({ stage }) => stage)")
    assert "slow-line" in stages


STORE = """window.bootPatience = 240;
Object.defineProperty(navigator.serviceWorker, "controller", { value: {} });
caches.match = async (address) => (String(address).includes("%s") ? undefined : new Response());
"""
"""A service worker controls the page, and its store has all files but those with these letters."""


@pytest.mark.parametrize(("absent", "told"), [("nothing", "slow"), ("python.zip", "slow-line")])
def test_what_lies_in_the_browser_itself_is_no_matter_of_the_network(
    open_page: OpenPage, network: Network, boot_site: Path, absent: str, told: str
) -> None:
    (boot_site / "patience.js").write_text(HURRIED + STORE % absent, encoding="utf-8")
    write_page(boot_site, name="kept.html", before=PATIENCE)
    network.held, network.seconds = "pyodide.asm.wasm", HELD / HURRY
    page = open_page(f"{network.address}/kept.html")
    assert booted(page).get("start") == "snapshot"
    stages = page.evaluate("window.progress.map(({ stage }) => stage)")
    slow = [stage for stage in stages if stage.startswith("slow")]
    assert slow[0] == told  # when all has come, a busy machine may be slow too
    assert slow.count("slow-line") == (told == "slow-line")


def test_a_scene_says_that_the_network_is_slow_until_python_is_there(
    open_page: OpenPage, widget_site: Path
) -> None:
    text = (widget_site / "coasting.html").read_text(encoding="utf-8")
    hurried = text.replace('<link rel="stylesheet"', f'{PATIENCE}<link rel="stylesheet"', 1)
    assert hurried != text
    (widget_site / "hurried.html").write_text(hurried, encoding="utf-8")
    (widget_site / "patience.js").write_text(HURRIED, encoding="utf-8")
    with serving(widget_site) as network:
        network.held, network.seconds = "memory.snapshot", HELD / HURRY
        page = open_page(f"{network.address}/hurried.html")
        note = page.locator("#coasting .carts-note")
        expect(note).to_contain_text("The network is slow")
        expect(page.locator("#coasting")).to_have_attribute("data-state", "live", timeout=LIVE)
        expect(note).to_be_hidden()
