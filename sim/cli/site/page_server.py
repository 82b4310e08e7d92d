"""The little web server of `carts serve`: MkDocs' own, with a page for what cannot be built."""

from __future__ import annotations

import html
import logging
import os
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from mkdocs.livereload import LiveReloadServer

LOOK_EVERY = 0.2
"""s between two looks at the files; MkDocs takes 0.5."""

WAIT_FOR_MORE = 0.05
"""s. An editor may write several files at once."""

TROUBLE = """\
<!doctype html><html lang="en"><head><meta charset="utf-8"><title>This cannot be built</title>
<style>body {{ font: 1rem/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 46rem;
padding: 0 1rem; color: #1a1a1a; background: #fff }} pre {{ white-space: pre-wrap;
border-left: 4px solid #c62828; padding-left: 1rem }}</style></head><body>
<h1>The pages cannot be built</h1><pre>{text}</pre>
<p>Mend it and save the file: this page comes back by itself.</p></body></html>"""


def _refused(start_response: Any, status: str) -> list[bytes]:
    start_response(status, [("Content-Type", "text/plain; charset=utf-8")])
    return [status.encode()]


def own_names(port: int) -> set[str]:
    """How a browser of this computer calls the server; it leaves out the web's own port."""
    names = {"127.0.0.1", "localhost"}
    return {f"{name}:{port}" for name in names} | (names if port == 80 else set())


class PageServer(LiveReloadServer):
    """Serves the folder `site` on this computer alone; bound to its port from the start."""

    allow_reuse_address = os.name != "nt"  # Windows would let two servers have one port

    def __init__(
        self, builder: Callable[[], None], trouble: Callable[[], str], site: Path, port: int
    ) -> None:
        super().__init__(builder, "127.0.0.1", port, str(site), polling_interval=LOOK_EVERY)
        self.build_delay = WAIT_FOR_MORE
        self.trouble = trouble
        logging.getLogger("mkdocs.livereload").setLevel(logging.ERROR)
        self.server_bind()
        self.server_activate()
        # A page elsewhere may let its own name point at this computer and read what is unpublished.
        self.names = own_names(self.server_port)

    def serve(self, *, open_in_browser: bool = False) -> None:
        """Answer requests and build at each change, until the program is ended."""
        self.observer.start()
        self.serve_thread.start()
        self._build_loop()  # type: ignore[no-untyped-call]

    def serve_request(self, environ: dict[str, Any], start_response: Any) -> Iterable[bytes]:
        """A file of the site, or in place of a page what is wrong."""
        text, path = self.trouble(), str(environ["PATH_INFO"])
        if environ.get("HTTP_HOST") not in self.names:
            return _refused(start_response, "403 Forbidden")
        if "\0" in path:
            return _refused(start_response, "404 Not Found")
        if not text or not path.endswith(("/", ".html")):
            return super().serve_request(environ, start_response)
        with self._epoch_cond:
            epoch = self._visible_epoch
        page = TROUBLE.format(text=html.escape(text)).encode()
        start_response("200 OK", [("Content-Type", "text/html; charset=utf-8")])
        return [self._inject_js_into_html(page, epoch)]  # type: ignore[no-untyped-call]
