"""Browsers, as the tests of the pages have them."""

from tests.web.conftest import (
    browser,
    browser_name,
    driver,
    open_page,
    site_server,
)

__all__ = [
    "browser",
    "browser_name",
    "driver",
    "open_page",
    "site_server",
]
