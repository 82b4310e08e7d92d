"""One window of WebKit for all that is looked at there."""

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
    """WebKit. Where it is not the tests are skipped and say so; never where root runs in CI."""
    if absent := missing():
        told = f"{absent} not found: `make browsers` as root installs webkit2gtk-driver and xvfb"
        if os.environ.get("CI") and os.geteuid() == 0:
            pytest.fail(told)
        pytest.skip(told)
    with webkit(tmp_path_factory.mktemp("webkit")) as opened:
        yield opened
