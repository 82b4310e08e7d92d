"""The server of a preview: by which names its own pages call it."""

from __future__ import annotations

from sim.cli.site.page_server import own_names


def test_a_browser_leaves_out_the_port_of_the_web_and_no_other() -> None:
    assert {"localhost", "127.0.0.1", "localhost:80", "127.0.0.1:80"} == own_names(80)
    assert {"localhost:8000", "127.0.0.1:8000"} == own_names(8000)
