"""An address with a scheme leads away from the site, in whatever letters the scheme is written.
Before, “Https://…” (as the keyboard of a phone begins a line) was a file that is not there.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from sim.pages.checks.lessons import check_paths
from sim.pages.text.elsewhere import leads_elsewhere

SCHEMES = ("https://", "Https://", "HTTPS://", "//")


@pytest.mark.parametrize(
    "address", [*(f"{one}example.org/a" for one in SCHEMES), "Mailto:a@b.org", " data:image/png,x"]
)
def test_a_scheme_leads_elsewhere(address: str) -> None:
    assert leads_elsewhere(address)


@pytest.mark.parametrize("address", ["two carts.md", "#end", "/a.png", "../a.png", "12:30.png"])
def test_a_file_of_the_site_does_not(address: str) -> None:
    assert not leads_elsewhere(address)


def codes(text: str, folder: Path) -> list[str]:
    lesson = folder / "worksheets" / "first.md"
    lesson.parent.mkdir()
    lesson.write_text(f"# First\n\n{text}\n", encoding="utf-8")
    return [finding.code for finding in check_paths([lesson], folder)]


@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_link_to_another_server_is_no_file_that_is_missing(scheme: str, tmp_path: Path) -> None:
    assert codes(f"[a film]({scheme}example.org/film)", tmp_path) == []


@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_picture_from_another_server_is_not_shown(scheme: str, tmp_path: Path) -> None:
    assert codes(f"![two carts]({scheme}example.org/a.png)", tmp_path) == ["blocked"]
