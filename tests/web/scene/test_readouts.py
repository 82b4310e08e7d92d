"""Values beside the picture, where a card is narrow."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.web.conftest import OpenPage
from tests.web.runtime.boot_site import ROOT

pytestmark = [pytest.mark.browser, pytest.mark.one_browser]


def test_a_value_that_needs_a_line_of_its_own_stands_right_below_its_name(
    tmp_path: Path, open_page: OpenPage
) -> None:
    sheet = (ROOT / "sim" / "web" / "css" / "carts.css").read_text(encoding="utf-8")
    row = "<div><dt>velocity seen from the camera</dt><dd>-0.300 m/s</dd></div>"
    (tmp_path / "a.html").write_text(
        f"<!doctype html><title>a</title><style>{sheet}</style><div class='carts'>"
        f"<dl class='carts-readouts' style='width: 16em'>{row}</dl></div>",
        encoding="utf-8",
    )
    page = open_page(tmp_path / "a.html")
    name, value = page.locator("dt").bounding_box(), page.locator("dd").bounding_box()
    assert name is not None
    assert value is not None
    below = value["y"] - (name["y"] + name["height"])
    assert 0 <= below < 4
