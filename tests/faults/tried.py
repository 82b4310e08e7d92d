"""One row: the copy of the site, its server, its browser; and the verdict."""

from __future__ import annotations

import functools
import http.server
import os
import shutil
import tempfile
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import quote, unquote, urlsplit

from playwright.sync_api import Browser, BrowserContext, Error, Playwright

from tests.web.conftest import LAUNCH

from .look import SETTLED, SOON, Seen, look, prepare
from .machine import NotHereError
from .table import PACKAGES, Fault
from .table import Browser as Own

ROOT = Path(__file__).parents[2]
PARTS = ("worksheets", "gallery", "assets")
LEFT_OUT = shutil.ignore_patterns("newtons_carts_class*", "newtons_carts_teacher*", "film*")
SILENT, OTHER, BROKEN, RIGHT, UNTRIED = "SILENT", "OTHER", "BROKEN", "", "untried"


@dataclass(frozen=True)
class Row:
    """`verdict`: SILENT: neither lives nor says; OTHER: not what must be seen; RIGHT."""

    name: str
    verdict: str
    live: str
    told: str

    def __str__(self) -> str:
        return f"{self.name:48} {self.verdict:8} {self.live:22} {self.told[:100]}"


Opened = tuple[BrowserContext, Callable[[], None]]
"""A browser, and what happens to its machine when the visits of before are over."""


@dataclass(frozen=True)
class Bench:
    """The shared browser, and the whole site from which the copies are made."""

    driver: Playwright
    browser: Browser
    whole: Path

    @classmethod
    @contextmanager
    def open(cls, driver: Playwright) -> Iterator[Bench]:
        with tempfile.TemporaryDirectory() as folder:
            Path(folder).chmod(0o755)
            for part in PARTS:
                shutil.copytree(ROOT / "site" / part, Path(folder, "whole", part), ignore=LEFT_OUT)
            browser = driver.chromium.launch(**LAUNCH["chromium"])
            yield cls(driver, browser, Path(folder, "whole"))
            browser.close()


class Handler(http.server.SimpleHTTPRequestHandler):
    """Tells nobody."""

    def __init__(self, *args: object, answer: object, **more: object) -> None:
        self.answer = answer
        super().__init__(*args, **more)  # type: ignore[arg-type]

    def do_GET(self) -> None:
        with suppress(ConnectionError):
            path = unquote(urlsplit(self.path).path)
            if not (self.answer and self.answer(self, path)):  # type: ignore[operator]
                super().do_GET()

    def log_message(self, *_: object) -> None:
        pass


@contextmanager
def address(fault: Fault, top: Path) -> Iterator[str]:
    """Where the page is opened, `top` being the folder around the site's."""
    page = quote(f"{fault.folder}/{fault.page}")
    if fault.mode == "disk":
        yield f"file://{quote(top.as_posix())}/{page}"
        return
    handler = functools.partial(Handler, directory=str(top), answer=fault.answer)
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        server.daemon_threads, server.block_on_close = True, False
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_address[1]}/{page}"
        server.shutdown()


@contextmanager
def _own(bench: Bench, own: Own, folder: Path) -> Iterator[Opened]:
    """A browser of its own on a changed machine."""
    program = folder / "browser"
    real = LAUNCH["chromium"]["executable_path"]
    program.write_text(f'#!/bin/sh\nHOME="{own.profile}" exec {own.before} {real} "$@"\n')
    program.chmod(0o755)
    options = {**LAUNCH["chromium"], "executable_path": str(program)}
    context = bench.driver.chromium.launch_persistent_context(
        str(own.profile), timeout=90_000, **options
    )
    context.set_default_timeout(90_000)
    filler = own.profile / "filler"
    try:
        yield context, functools.partial(_fill, filler) if own.full else _nothing
    finally:
        filler.unlink(missing_ok=True)
        with suppress(Exception):  # a browser without memory may be gone
            context.close()


def _nothing() -> None:
    pass


def _fill(filler: Path) -> None:
    """To the last byte."""
    with suppress(OSError), filler.open("wb", buffering=0) as file:
        while True:
            file.write(bytes(1 << 16))
    with suppress(OSError), filler.open("ab", buffering=0) as file:
        while True:
            file.write(b"0")


@contextmanager
def context_of(fault: Fault, bench: Bench, site: Path, folder: Path) -> Iterator[Opened]:
    if fault.machine is None:
        context = bench.browser.new_context()
        context.set_default_timeout(1000 * SETTLED)
        yield context, _nothing
        context.close()
        return
    profile = folder / "profile"
    profile.mkdir()
    with fault.machine(site, profile) as own, _own(bench, own, folder) as opened:
        yield opened


def tried(bench: Bench, fault: Fault, usual: frozenset[str]) -> Row:
    """The fault's row. `usual`: what the page says when nothing is wrong."""
    with tempfile.TemporaryDirectory(dir=bench.whole.parent) as name:
        folder = Path(name)
        folder.chmod(0o755)
        site = folder / fault.folder
        shutil.copytree(bench.whole, site, copy_function=os.link)
        fault.harm(site)
        try:
            with address(fault, folder) as where, context_of(fault, bench, site, folder) as opened:
                context, worsen = opened
                prepare(context, fault, where)
                worsen()
                return _row(fault, look(context, fault, where, usual))
        except NotHereError as lack:
            return Row(fault.name, UNTRIED, "", str(lack))
        except Error as broken:
            return Row(fault.name, BROKEN, "", " ".join(str(broken).split()))


def _row(fault: Fault, seen: Seen) -> Row:
    lives = (
        seen.live and (seen.kept or fault.page == PACKAGES) and (seen.again or not fault.earlier)
    )
    lives = lives and not seen.dead
    closed = seen.said and not seen.fields
    right = {
        "lives": lives,
        "says": seen.said and (seen.again or not fault.earlier),
        "closed": closed,
        "either": lives or seen.said,
        "blank": not seen.fields and not seen.live,
    }[fault.must]
    silent = not (lives or seen.said) and fault.must != "blank"
    verdict = SILENT if silent else RIGHT if right else OTHER
    shown = " ".join(
        ["live" if seen.live else "-", "kept" if seen.kept else "-"]
        + ([f"{seen.after:.1f}s"] if seen.told and seen.after <= SOON else [])
        + [f"{seen.fields}f"]
    )
    dead = f"dead: {' '.join(seen.dead)} " if seen.dead else ""
    return Row(fault.name, verdict, shown, dead + " | ".join(seen.told))
