"""The site as it is built: nothing from outside, the policy on every page, sizes within bounds."""

from __future__ import annotations

import gzip
import re
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

pytestmark = pytest.mark.slow  # builds the site

MOST_WITHOUT_RUNTIME = 461_000  # bytes as gzip, everything that such a page loads, with the words
# of all pages for the search: ten lessons in four languages brought those to 96 kB (460.6 kB)
USUAL_FORMULA_FONTS = ("Main-Bold", "AMS-Regular")  # beside those within the style sheet
MOST_HTML_PER_SCENE = 61_000  # bytes; graphs have a number on each side of zero
MOST_HTML_PER_MAP = 40_000
MOST_RUNTIME = 14_000_000  # bytes on disk, once per site, without packages
MOST_CLASSROOM = 291_000  # one page's; without annotations of functions, as all of ours: 288.6 kB
MOST_MEASURED = 232_500  # few pages'; sentences as templates with their values, no annotations of
# functions, and what widens intervals where the model is not the truth: 231.8 kB
MOST_PROOF = 96_000  # read when a reader asks for a proof: 93.9 kB
MOST_FILM = 130_000  # bytes as gzip
MOST_TEACHER = 1_450_000  # with YAML, Markdown and templates; loaded by teachers only
# More: numpy because a page has a map, scipy because one has balls; and what those and teacher mode
# need of the standard library.
MOST_PACKAGES = 22_300_000


class Links(HTMLParser):
    """Addresses in a page: those it loads by itself, and those a reader may follow."""

    def __init__(self) -> None:
        super().__init__()
        self.loaded: list[str] = []
        self.followed: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            own = (value or "").startswith("#")  # a place in the page itself
            if name in ("href", "src", "srcset", "data", "poster", "action") and value and not own:
                (self.followed if tag == "a" else self.loaded).append(value)


@cache
def links(page: Path) -> Links:
    """Read once for all tests: most of their time is the parser's."""
    parser = Links()
    parser.feed(page.read_text(encoding="utf-8"))
    return parser


def pages(site: Path) -> list[Path]:
    found = sorted(site.rglob("*.html"))
    assert len(found) > 30
    return found


def sheets(site: Path) -> list[Path]:
    found = sorted(site.rglob("*.css"))
    assert "carts.css" in {sheet.name for sheet in found}
    return found


def has_scene(page: Path) -> bool:
    text = page.read_text(encoding="utf-8")
    return any(f"<carts-{block}" in text for block in ("scene", "map", "cost", "hard"))


def in_css(sheet: Path) -> list[str]:
    text = sheet.read_text(encoding="utf-8")
    found = re.findall(r"url\(\s*[\"']?([^)\"']+)", text)
    return [address for address in found if not address.startswith("data:")]


def test_the_lessons_and_pages_are_there(site: Path) -> None:
    for name in ("index.html", "about.html", "physics/index.html", "teachers/index.html"):
        assert (site / name).is_file(), name
    assert (site / "worksheets" / "newtons-first-law.html").is_file()
    assert (site / "third-party-licenses.txt").is_file()


def test_everything_a_page_loads_lies_in_the_site(site: Path) -> None:
    for page in pages(site):
        for address in links(page).loaded:
            if address.startswith("data:"):
                continue
            parts = urlsplit(address)
            assert not parts.scheme, f"{page.name} loads {address}"
            assert not parts.netloc, f"{page.name} loads {address}"
            assert not parts.path.startswith("/"), f"{page.name} loads {address}"
            target = page.parent / unquote(parts.path)
            assert target.resolve().is_relative_to(site.resolve())
            assert target.is_file(), f"{page.name} loads {address}, which is not there"


def test_every_link_inside_the_site_leads_somewhere(site: Path) -> None:
    for page in pages(site):
        for address in links(page).followed:
            parts = urlsplit(address)
            if parts.scheme or parts.netloc or not parts.path:
                continue
            target = page.parent / unquote(parts.path)
            target = target / "index.html" if target.is_dir() else target
            assert target.is_file(), f"{page.relative_to(site)} links to {address}"


def test_everything_a_style_sheet_loads_lies_in_the_site(site: Path) -> None:
    for sheet in sheets(site):
        for address in in_css(sheet):
            if address.startswith("#"):
                continue
            assert not urlsplit(address).scheme, f"{sheet.name} loads {address}"
            assert (sheet.parent / address.split("#")[0].split("?")[0]).is_file(), address


def test_no_sheet_imports_another(site: Path) -> None:
    for sheet in sheets(site):
        assert "@import" not in sheet.read_text(encoding="utf-8"), sheet.name


def test_the_policy_is_first_on_every_page(site: Path, hosted_site: Path) -> None:
    for folder in (site, hosted_site):
        for page in pages(folder):
            text = page.read_text(encoding="utf-8")
            assert re.search(r"<head>\s*<meta http-equiv=\"Content-Security-Policy\"", text), page
            assert "<meta charset" in text[:1024], page


def test_no_page_holds_what_the_policy_forbids(site: Path) -> None:
    from sim.pages.head.policy import inline_scripts
    from sim.pages.text.blocked import blocked

    for page in pages(site):
        text = page.read_text(encoding="utf-8")
        theirs = len(inline_scripts(text))
        found = [what for what in blocked(text) if not what.startswith("<script>")]
        assert found == [], page
        assert text.count("'sha256-") == theirs, page


def test_only_pages_with_a_scene_load_its_script(site: Path) -> None:
    loading = {
        page
        for page in pages(site)
        if any(address.endswith("carts/carts.js") for address in links(page).loaded)
    }
    assert loading == set(filter(has_scene, pages(site))) != set()


def test_only_pages_with_formulas_load_katex(site: Path) -> None:
    loading = {
        page for page in pages(site) if any("katex" in address for address in links(page).loaded)
    }
    with_formulas = {
        page for page in pages(site) if 'class="arithmatex"' in page.read_text(encoding="utf-8")
    }
    assert loading == with_formulas != set()


def test_only_pages_that_name_a_world_carry_what_runs_it(site: Path) -> None:
    texts = {page: page.read_text(encoding="utf-8") for page in pages(site)}
    named = {page for page, text in texts.items() if "<carts-worlds" in text}
    assert named
    for what in ("carts/worlds.js", "newtons-carts-worlds"):
        assert {page for page, text in texts.items() if what in text} == named


def test_a_page_names_its_site_for_the_storage(site: Path) -> None:
    for page in pages(site):
        assert '<meta name="carts-site" content="newtons-carts">' in page.read_text("utf-8")


@cache
def packed(path: Path) -> int:
    return len(gzip.compress(path.read_bytes(), 9, mtime=0))


def test_a_page_without_the_runtime_is_light(site: Path) -> None:
    """Counted as if the page needed every font of its sheets: more than any browser loads."""
    counted = [
        page
        for page in pages(site)  # the others start Python
        if not has_scene(page) and "<carts-law" not in page.read_text(encoding="utf-8")
    ]
    assert len(counted) > 10
    for page in counted:
        files = {page}
        for address in links(page).loaded:
            target = (page.parent / unquote(urlsplit(address).path)).resolve()
            if not address.startswith("data:"):
                files.add(target)
        sheets = [file for file in files if file.suffix == ".css" and "katex" not in file.name]
        files |= {(s.parent / a).resolve() for s in sheets for a in in_css(s) if "#" not in a}
        if any("katex" in file.name for file in files):
            fonts = site / "assets" / "carts" / "katex" / "fonts"
            files |= {fonts / f"KaTeX_{face}.woff2" for face in USUAL_FORMULA_FONTS}
        size = sum(map(packed, files)) + packed(site / "search" / "search_index.js")
        assert size <= MOST_WITHOUT_RUNTIME, f"{page.name}: {size} bytes"


def test_a_scene_costs_little_html(site: Path) -> None:
    found = {
        page: re.findall(
            r"<carts-scene\b.*?</carts-scene>", page.read_text(encoding="utf-8"), re.DOTALL
        )
        for page in pages(site)
    }
    assert any(found.values())
    for page, scenes in found.items():
        if scenes:
            each = sum(len(scene.encode()) for scene in scenes) / len(scenes)
            assert each <= MOST_HTML_PER_SCENE, f"{page.name}: {each:.0f} bytes per scene"


def test_a_map_costs_little_html(site: Path) -> None:
    maps = re.findall(
        r"<carts-map\b.*?</carts-map>",
        (site / "physics" / "map.html").read_text(encoding="utf-8"),
        re.DOTALL,
    )
    assert len(maps) == 4
    assert max(len(text.encode()) for text in maps) <= MOST_HTML_PER_MAP


def test_the_runtime_fits(site: Path) -> None:
    files = list((site / "assets" / "carts" / "runtime").iterdir())
    packages = [p for p in files if p.name.startswith(("numpy", "scipy", "python-more"))]
    classroom = [p for p in files if p.name.startswith("newtons_carts_class")]  # for one page
    assert 0 < sum(p.stat().st_size for p in classroom) <= MOST_CLASSROOM
    measured = [p for p in files if p.name.startswith("newtons_carts_measured")]  # for few pages
    assert sum(p.stat().st_size for p in measured) <= MOST_MEASURED
    teacher = [p for p in files if p.name.startswith("newtons_carts_teacher")]
    assert 0 < sum(p.stat().st_size for p in teacher) <= MOST_TEACHER
    proof = [p for p in files if p.name.startswith("newtons_carts_proof")]
    assert 0 < sum(p.stat().st_size for p in proof) <= MOST_PROOF
    few = (*classroom, *measured, *teacher, *proof)
    size = sum(p.stat().st_size for p in files if p not in few)
    extra = sum(p.stat().st_size for p in packages)
    assert 0 < extra <= MOST_PACKAGES
    assert size - extra <= MOST_RUNTIME


def test_no_page_loads_what_reads_films_before_a_reader_chooses_one(site: Path) -> None:
    assets = site / "assets" / "carts"
    script = assets / "film.js"
    assert len(gzip.compress(script.read_bytes())) <= MOST_FILM
    for page in pages(site):
        assert not [address for address in links(page).loaded if script.name in address]
    assert "carts-film" not in (assets / "carts.css").read_text(encoding="utf-8")
    holding = [
        path.name
        for path in assets.glob("*.js")
        if "mediabunny" in path.read_text(encoding="utf-8")
    ]
    assert holding == [script.name]
    assert "mediabunny" in (site / "third-party-licenses.txt").read_text(encoding="utf-8")


def test_only_pages_with_balls_load_scipy(site: Path) -> None:
    loading = {
        page.relative_to(site).as_posix()
        for page in pages(site)
        if re.search(r'data-packages="[^"]*scipy', page.read_text(encoding="utf-8"))
    }
    assert loading == {"gallery/balls.html"}


def test_nothing_for_developers_only_is_shipped(site: Path) -> None:
    names = {path.suffix for path in site.rglob("*") if path.is_file()}
    known = {".html", ".css", ".csv", ".js", ".json", ".png", ".svg", ".txt", ".woff2"}
    assert names <= known, names


def test_the_licence_file_names_what_the_runtime_holds(site: Path) -> None:
    text = (site / "third-party-licenses.txt").read_text(encoding="utf-8")
    for work in ("Material for MkDocs", "KaTeX", "Roboto", "Pyodide", "CPython", "lunr"):
        assert work in text
