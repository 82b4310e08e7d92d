"""How MkDocs hears of mistakes: as its warnings, which stop a strict build, or as its own error."""

from __future__ import annotations

import logging
from collections.abc import Iterator
from contextlib import contextmanager

from mkdocs.exceptions import PluginError
from mkdocs.utils import CountHandler

from sim.pages.findings import Finding, SiteError

log = logging.getLogger("mkdocs.plugins.carts")


@contextmanager
def stopping() -> Iterator[None]:
    """MkDocs stops with a message, not with a traceback."""
    try:
        yield
    except SiteError as error:
        raise PluginError(str(error)) from error


def do_not_count_warnings() -> None:
    """A strict build stops at the end if there were warnings; a preview goes on."""
    mkdocs = logging.getLogger("mkdocs")
    for handler in [h for h in mkdocs.handlers if isinstance(h, CountHandler)]:
        mkdocs.removeHandler(handler)


def report(finding: Finding) -> None:
    """A warning: it stops a strict build and leaves a preview running."""
    log.warning("%s", finding)
