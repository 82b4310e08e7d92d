"""One window of WebKit for all that is looked at there, and one as a reader has it."""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest

from tests.web.conftest import site_server

from .webdriver import Session
from .webkit import missing, webkit

__all__ = ["site_server"]


@pytest.fixture(scope="session")
def window(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Session]:
    """WebKit for pages that live a moment. Where it is not the tests are skipped and say so; never
    where root runs in CI."""
    _ask_for_it()
    with webkit(tmp_path_factory.mktemp("webkit"), briefly=True) as opened:
        yield opened


@pytest.fixture
def window_for_long(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Session]:
    """WebKit that compiles what runs for long for speed, as a reader's does."""
    _ask_for_it()
    with webkit(tmp_path_factory.mktemp("webkit")) as opened:
        yield opened


def _ask_for_it() -> None:
    if absent := missing():
        told = f"{absent} not found: `make browsers` as root installs webkit2gtk-driver and xvfb"
        if os.environ.get("CI") and os.geteuid() == 0:
            pytest.fail(told)
        pytest.skip(told)
