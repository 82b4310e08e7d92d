"""The guard that all browser tests rely on: it sees every request that leaves the site."""

from __future__ import annotations

import pytest

from tests.web.conftest import is_inside

HOME = "/tmp/a site/"
PAGE = "file:///tmp/a%20site/index.html"


@pytest.mark.parametrize(
    "url", [PAGE, "file:///tmp/a%20site/assets/x.js", "data:,", "blob:null/1", "about:blank"]
)
def test_what_belongs_to_the_site_is_inside(url: str) -> None:
    assert is_inside(url, PAGE, HOME)


@pytest.mark.parametrize(
    "url",
    [
        "https://example.org/",
        "file:///tmp/other/x.js",
        "file:///tmp/a%20site/../other/x.js",
        "file:///tmp/a%20site-2/x.js",
        "http://127.0.0.1/x.js",
    ],
)
def test_everything_else_is_outside(url: str) -> None:
    assert not is_inside(url, PAGE, HOME)


def test_another_port_is_another_site() -> None:
    served = "http://127.0.0.1:8000/index.html"
    assert is_inside("http://127.0.0.1:8000/x.js", served, "/")
    assert not is_inside("http://127.0.0.1:8001/x.js", served, "/")
