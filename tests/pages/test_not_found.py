"""An address that leads nowhere leads home."""

from __future__ import annotations

from pathlib import Path

import pytest

from sim.pages.text.not_found import THEMES, with_help

pytestmark = pytest.mark.slow  # builds the site


@pytest.mark.parametrize(
    ("built", "home"), [("site", "index.html"), ("hosted_site", "/index.html")]
)
def test_a_missing_page_says_where_to_go(
    built: str, home: str, request: pytest.FixtureRequest
) -> None:
    site: Path = request.getfixturevalue(built)
    html = (site / "404.html").read_text(encoding="utf-8")
    assert THEMES not in html
    assert f'<a href="{home}">Home, with all lessons</a>' in html


def test_it_speaks_the_sites_language_and_other_pages_stay() -> None:
    page = f'<html lang="ms"><body>{THEMES}</body></html>'
    made = with_help(page, "../")
    assert "Home, with all lessons" not in made
    assert '<a href="../index.html">' in made
    assert with_help("<html><body>x</body></html>", "../") == "<html><body>x</body></html>"
