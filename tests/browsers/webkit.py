"""WebKitGTK, the engine of Safari and of every browser on an iPad, as Debian has it.

`make browsers` installs it. It needs a screen: one of Xvfb's, that nobody sees.
"""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from urllib.error import URLError
from urllib.request import urlopen

from .webdriver import Session, soon

NEEDED = ("WebKitWebDriver", "Xvfb")
OPTIONS = {"browserName": "MiniBrowser"}
# What runs for long is compiled a third time for speed, beside what runs: of a visit that lasts a
# moment, Python's start included, that is a third of all work.
BRIEFLY = {"JSC_useOMGJIT": "0"}
# Nobody sees what is painted. Layers, which here the processor composes and no graphics card, are
# half of all work while a run plays.
PLAINLY = {"WEBKIT_DISABLE_COMPOSITING_MODE": "1", "WEBKIT_SKIA_ENABLE_CPU_RENDERING": "1"}
STARTED = 20.0  # s; a driver that says nothing by then will say nothing


def missing() -> str:
    """The programs that are not here, in words; empty where all are."""
    return " and ".join(name for name in NEEDED if shutil.which(name) is None)


@contextmanager
def webkit(folder: Path, *, briefly: bool = False) -> Iterator[Session]:
    """A window of WebKit whose files lie in `folder`, downloads too; all is ended afterwards.
    `briefly`: for pages that live a moment."""
    more = PLAINLY | (BRIEFLY if briefly else {})
    with screen() as display, _driver(display, folder, more) as address:
        session = Session.start(address, OPTIONS, folder)
        try:
            yield session
        finally:
            with suppress(Exception):  # it is ended with its driver anyway
                session.close()


@contextmanager
def screen() -> Iterator[str]:
    read, write = os.pipe()
    command = ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"]
    with subprocess.Popen(command, pass_fds=[write], stderr=subprocess.DEVNULL) as server:
        os.close(write)
        try:
            with os.fdopen(read) as told:
                yield f":{told.readline().strip()}"
        finally:
            server.terminate()


@contextmanager
def _driver(display: str, folder: Path, more: dict[str, str]) -> Iterator[str]:
    own = {name: str(folder) for name in ("HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME")}
    env = {**os.environ, **own, **more, "DISPLAY": display, "GDK_BACKEND": "x11"}
    port = _free_port()
    command = ["WebKitWebDriver", f"--port={port}"]
    with subprocess.Popen(
        command, env=env, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    ) as driver:
        try:
            yield _listening(f"http://127.0.0.1:{port}")
        finally:
            driver.terminate()


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def _listening(address: str) -> str:
    def heard() -> bool:
        with suppress(URLError, ConnectionError):
            urlopen(f"{address}/status", timeout=1).close()
            return True
        return False

    soon(heard, STARTED, "a word of WebKitWebDriver")
    return address
