"""An address that leads nowhere leads home."""

from __future__ import annotations

import functools
import http.server
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from sim.cli.site.build import build_site
from sim.pages.findings import SiteError
from sim.pages.offline.nowhere import ADDRESS, address_told
from sim.pages.text.not_found import THEMES, with_help
from tests.pages.given.small_site import CONFIG, MakeSite, lesson, make_site
from tests.web.conftest import OpenPage, browser, browser_name, driver, open_page

__all__ = ["browser", "browser_name", "driver", "make_site", "open_page"]  # fixtures


def built(make_site: MakeSite, config: str = CONFIG, *, hosted: bool = True) -> Path:
    root = make_site(config, first=lesson())
    site = build_site(root, hosted=hosted, strict=True)
    assert site is not None
    return site


def missing_page(site: Path) -> str:
    return (site / "404.html").read_text(encoding="utf-8")


def test_a_missing_page_of_a_folder_says_where_to_go(make_site: MakeSite) -> None:
    html = missing_page(built(make_site, hosted=False))
    assert THEMES not in html
    assert '<a href="index.html">Home, with all lessons</a>' in html


@pytest.mark.parametrize("told_by", ["mkdocs.yml", "the environment"])
def test_a_missing_page_of_a_known_address_names_its_files_from_there(
    make_site: MakeSite, monkeypatch: pytest.MonkeyPatch, told_by: str
) -> None:
    address = "https://school.github.io/carts"
    config = CONFIG
    if told_by == "mkdocs.yml":
        config += f"site_url: {address}/\n"
    else:  # as the automatic build on GitHub does, without a slash
        monkeypatch.setenv(ADDRESS, address)
    html = missing_page(built(make_site, config))
    assert '<a href="/carts/index.html">Home, with all lessons</a>' in html
    assert 'src="/carts/assets/carts/answers.js' in html


def test_an_address_that_is_none_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(ADDRESS, "school.example")
    with pytest.raises(SiteError, match=r"school\.example"):
        address_told()


@pytest.mark.browser
@pytest.mark.one_browser
@pytest.mark.parametrize("place", ["typo.html", "typo", "worksheets/deeper/typo.html"])
def test_a_missing_page_of_an_unknown_address_finds_home_and_needs_no_file(
    make_site: MakeSite, open_page: OpenPage, place: str
) -> None:
    """On a project page of GitHub the site is below the root, and no build was told."""
    site = built(make_site)
    html = missing_page(site)
    assert "watchdog" not in html and 'src="' not in html and "stylesheet" not in html
    with served_below_the_root(site) as address:
        page = open_page(f"{address}/{site.name}/{place}")
        page.get_by_role("link", name="Home, with all lessons").click()
        page.wait_for_url(f"{address}/{site.name}/index.html")


def test_it_says_so_in_the_language_of_the_site(make_site: MakeSite) -> None:
    config = CONFIG.replace("font: false", "font: false, language: ms")
    html = missing_page(built(make_site, config))
    assert '<html lang="ms">' in html and "Home, with all lessons" not in html


@contextmanager
def served_below_the_root(site: Path) -> Iterator[str]:
    """An address; what is not there is answered with the site's 404.html, as GitHub does."""

    class Handler(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_: object) -> None:
            pass

        def do_GET(self) -> None:
            if Path(self.translate_path(self.path)).is_file():
                super().do_GET()
            else:
                self.send_response(404)
                self.send_header("Content-Type", "text/html")
                self.end_headers()
                self.wfile.write((site / "404.html").read_bytes())

    made = functools.partial(Handler, directory=str(site.parent))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), made) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_address[1]}"
        server.shutdown()


def test_it_speaks_the_sites_language_and_other_pages_stay() -> None:
    page = f'<html lang="ms"><body>{THEMES}</body></html>'
    made = with_help(page, "../")
    assert "Home, with all lessons" not in made
    assert '<a href="../index.html">' in made
    assert with_help("<html><body>x</body></html>", "../") == "<html><body>x</body></html>"
