"""The files that every built site carries beside its pages: styles, fonts, KaTeX, search from disk.

All of them come from this repository, from npm's packages in node_modules/ (fonts, KaTeX) or from
the installed theme; none is fetched when a page is opened.
"""

from __future__ import annotations

import json
import re
from base64 import b64encode
from collections.abc import Iterator
from pathlib import Path

import sim

ASSETS = "assets/carts/"
FILM = "film.js"
"""Loaded when a reader chooses a film; no page names it."""
_COMMENT = re.compile(rb"/\*.*?\*/\s*", re.DOTALL)
OWN_STYLES = ("measured.css", "class.css", "sheets.css")
"""Of the pages with readings of real carts, of class results, and of those that are made to be
printed, beside that of all."""
SEARCH_FROM_DISK = ASSETS + "iframe-worker.js"  # a name that keeps the theme from adding its own

_WEB = Path(sim.__file__).parent / "web"
_CLASSROOM = Path(sim.__file__).parent / "classroom"  # its reports are saved with their style
_ROBOTO = "@fontsource-variable/roboto/files/roboto-{}.woff2"
_MONO = "@fontsource/roboto-mono/files/roboto-mono-{}.woff2"
# Within the style sheet, so that no line moves when they come: browsers have them at once.
FONTS_INSIDE = (_ROBOTO.format("latin-wght-normal"), _MONO.format("latin-400-normal"))
_FORMULA_FACES = ("Main-Regular", "Math-Italic", *(f"Size{k}-Regular" for k in range(1, 5)))
FORMULA_FONTS_INSIDE = tuple(f"KaTeX_{face}.woff2" for face in _FORMULA_FACES)
FONTS = (_ROBOTO.format("latin-ext-wght-normal"), _MONO.format("latin-ext-400-normal"))
# Fallbacks for browsers that cannot run our pages anyway; without them no file is missing.
_OLD_FONT = re.compile(r',\s*url\([^)]*\.(?:woff|ttf)\)\s*format\("[^"]*"\)')


class MissingFilesError(RuntimeError):
    """Something that the site is made of is not there; the message says what to do."""


def site_files(node_modules: Path) -> dict[str, bytes]:
    """Every file by its address in the site, without the scripts of scenes."""
    return {ASSETS + name: content for name, content in _files(node_modules)}


def scene_script() -> bytes:
    """The committed bundle that brings scenes to life: assets/carts/carts.js."""
    return _read(_WEB / "dist" / "carts.js", "make bundle")


def class_script() -> bytes:
    """The committed bundle of the page "Class results": assets/carts/class.js."""
    return _read(_WEB / "dist" / "class.js", "make bundle")


def measured_script() -> bytes:
    """The committed bundle of pages with readings of real carts: assets/carts/measured.js."""
    return _read(_WEB / "dist" / "measured.js", "make bundle")


def film_script() -> bytes:
    """The committed bundle that follows marks in films: asked for by measured.js beside it."""
    return _read(_WEB / "dist" / FILM, "make bundle")


def own_script(name: str) -> bytes:
    """A committed bundle that only some pages have: assets/carts/NAME.js."""
    return _read(_WEB / "dist" / f"{name}.js", "make bundle")


def teacher_files() -> tuple[bytes, bytes]:
    """Script and style of teacher mode: assets/carts/teacher.js and teacher.css."""
    style = _read(_WEB / "teach" / "teacher.css", "git restore sim/web/teach")
    return _read(_WEB / "dist" / "teacher.js", "make bundle"), style


def search_from_disk(worker: str) -> str:
    """The script that starts the theme's search (text of its worker) from within the page."""
    script = _read(_WEB / "site" / "search-from-disk.js", "git restore sim/web/site").decode()
    # json.dumps makes a JavaScript string of any text; < is written out so that no text can
    # ever look like the end of a script.
    return script.replace('"@@SEARCH_WORKER@@"', json.dumps(worker).replace("<", "\\u003c"), 1)


def search_words(index: str) -> str:
    """The script with what is searched, from the theme's JSON; letters stand in it as letters: a
    Tamil one takes half as much so."""
    text = json.dumps(json.loads(index), ensure_ascii=False, separators=(",", ":"))
    return f"var __index = {text}"


def _files(node_modules: Path) -> Iterator[tuple[str, bytes]]:
    yield "site.css", _bare(_style_sheet(node_modules))
    fonts = _WEB / "site" / "formula-fonts.js"
    yield fonts.name, _read(fonts, "git restore sim/web/site")
    yield "answers.js", _read(_WEB / "dist" / "answers.js", "make bundle")
    own = {name: _WEB / "css" / name for name in OWN_STYLES}
    sheets = [path for path in sorted(_WEB.glob("css/*.css")) if path not in own.values()]
    yield "carts.css", b"\n".join(_bare(path.read_bytes()) for path in sheets)
    sheets_of_class = (_CLASSROOM / "show" / "report.css", _CLASSROOM / "handouts" / "paper.css")
    report = b"".join(sheet.read_bytes() for sheet in sheets_of_class)
    for name, path in own.items():
        yield name, path.read_bytes() + (report if name == "class.css" else b"")
    for font in FONTS:
        path = node_modules / font
        yield f"fonts/{path.name}", _read(path, "make site")
    katex = node_modules / "katex" / "dist"
    yield "katex/katex.min.js", _read(katex / "katex.min.js", "make site")
    css = _OLD_FONT.sub("", _read(katex / "katex.min.css", "make site").decode())
    for name in FORMULA_FONTS_INSIDE:
        css = css.replace(f"fonts/{name}", _data(katex / "fonts" / name))
    yield "katex/katex.min.css", css.encode()
    for face in sorted((katex / "fonts").glob("*.woff2")):
        yield f"katex/fonts/{face.name}", face.read_bytes()


def _bare(sheet: bytes) -> bytes:
    """A sheet of ours without its comments: every page carries it."""
    return _COMMENT.sub(b"", sheet)


def _style_sheet(node_modules: Path) -> bytes:
    sheet = _read(_WEB / "site" / "site.css", "git restore sim/web/site")
    for font in FONTS_INSIDE:
        path = node_modules / font
        sheet = sheet.replace(f"fonts/{path.name}".encode(), _data(path).encode())
    return sheet


def _data(font: Path) -> str:
    """A font as an address that holds it: it is there with the style sheet, no line moves later."""
    return f"data:font/woff2;base64,{b64encode(_read(font, 'make site')).decode()}"


def _read(path: Path, remedy: str) -> bytes:
    try:
        return path.read_bytes()
    except FileNotFoundError:
        raise MissingFilesError(f"{path.name} is missing. Run “{remedy}” first.") from None
