"""A server that keeps one file of a site back for a while; a watchdog that looks when told."""

from __future__ import annotations

import functools
import http.server
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

# The watchdog looks three seconds after the page began: here when a test says so.
WHEN_TOLD = """const later = setTimeout;
  window.setTimeout = (does, ms, ...more) => {
    if (ms !== 3000 || window.watchdogLooks) return later(does, ms, ...more);
    window.watchdogLooks = does;
  };"""


@contextmanager
def holding_back(folder: Path, ending: str) -> Iterator[tuple[str, threading.Event]]:
    """Address of a folder's server, and the event before which no file with this ending comes."""
    go_on = threading.Event()

    class Handler(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_: object) -> None:
            pass

        def do_GET(self) -> None:
            if self.path.split("?")[0].endswith(ending):
                go_on.wait(timeout=60)
            super().do_GET()

    made = functools.partial(Handler, directory=str(folder))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), made) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_address[1]}", go_on
        go_on.set()
        server.shutdown()
