"""A built lesson as one HTML file: text, pictures, questions, scenes and Python, no folder.

The text of the page is kept as the generator made it; menus, search and teacher mode, which need
other files, are left out. Every style and script stands in the file and is allowed by its hash.
"""

from __future__ import annotations

import base64
import html
import json
import mimetypes
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from urllib.parse import unquote

from sim.pages.language import ENGLISH, mark, of_page, speaking, words
from sim.pages.prepared import FOLDER as PREPARED
from sim.pages.single.all_inside import INSIDE, policy
from sim.pages.site_files import ASSETS, FILM
from sim.pages.watchdog import watchdog

_LOOK = """\
html { font-size: 125%; } body { margin: 0; }
main, details.carts-about { margin: 0 auto; max-width: 42rem; padding: 0 0.8rem; }
details.carts-about { padding-bottom: 4rem; font: 0.7rem/1.5 system-ui, sans-serif; }
details.carts-about pre { white-space: pre-wrap; }
"""
_DARK = """\
const dark = matchMedia("(prefers-color-scheme: dark)");
const follow = () => { document.body.dataset.mdColorScheme = dark.matches ? "slate" : "default"; };
dark.addEventListener("change", follow);
follow();
"""
_ONLY_IN_A_SITE = ("iframe-worker", "teacher", "hosted.js", "offline.js")
_WITH_PYTHON = ("/carts.js", "/measured.js", "/law.js")
_MADE = mark("Made with Newton's Carts. Licences")
_PAGE = """\
<!doctype html>
<html lang="{language}" class="{kinds}"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="carts-site" content="{site_id}"><meta name="carts-page" content="{page_id}">
<title>{title}</title><link rel="icon" href="data:,">
<script>{watching}</script>
{styles}
</head>
<body dir="ltr" data-md-color-scheme="default"
  data-md-color-primary="custom" data-md-color-accent="custom">
<main>{article}</main>
<details class="carts-about"><summary>{made}</summary>
<pre>{licences}</pre></details>
{data}
{scripts}
</body></html>
"""


def single_lesson(
    page: Path, site: Path, runtime: Iterable[str], elsewhere: Mapping[str, str] | None = None
) -> str:
    """The file for the built page; `runtime`: scripts of a runtime that has what the page needs.

    `elsewhere`: scripts that are put in later, with their addresses: `data-from` names them.
    """
    text = page.read_text(encoding="utf-8")
    sheets = [
        _beside(page, href) for href in re.findall(r'<link rel="stylesheet" href="(.+?)"', text)
    ]
    styles = [_LOOK, *(_with_files(sheet) for sheet in sheets)]
    ours = re.findall(rf'<script src="([^"]*{ASSETS}[^"]+)"', text)
    sources = [
        src for src in dict.fromkeys(ours) if not any(name in src for name in _ONLY_IN_A_SITE)
    ]
    live = any(src.endswith(_WITH_PYTHON) for src in sources)
    scripts = [_DARK, INSIDE, *(runtime if live else ()), *_prepared(text, site)]
    for src in sources:
        if src.endswith("/measured.js"):  # in one file nothing can be asked for later
            scripts.append(_beside(page, src).with_name(FILM).read_text(encoding="utf-8"))
        scripts.append(_beside(page, src).read_text(encoding="utf-8"))
    data = re.findall(r'<script type="application/json" id="carts-lesson">.*?</script>', text, re.S)
    licences = (site / "third-party-licenses.txt").read_text(encoding="utf-8")
    language = _first(r'<html lang="([^"]*)"', text) or ENGLISH
    said = words(of_page(None, "", language))
    with speaking(said):
        watching = watchdog()  # what waits for a run is closed by its class, as in the site
    return _PAGE.format(
        language=language,
        made=html.escape(said.get(_MADE, _MADE), quote=False),
        watching=watching,
        kinds=_first(r'<html [^>]*class="no-js *([^"]*)"', text),
        policy=policy(styles, [watching, *scripts], {"font-src": "data:"}),
        site_id=_first(r'name="carts-site" content="([^"]*)"', text),
        page_id=_first(r'name="carts-page" content="([^"]*)"', text),
        title=_first(r"<title>(.*?)</title>", text),
        styles="\n".join(f"<style>{style}</style>" for style in styles),
        article=_article(text, page),
        licences=html.escape(licences),
        data="\n".join(data),
        scripts="\n".join(_script(script, elsewhere or {}) for script in scripts),
    )


def _prepared(text: str, site: Path) -> list[str]:
    """The scripts with the runs that were prepared for the scenes of the page."""
    tables = re.findall(r'<carts-scene[^>]* data-prepared="([^"]*)"', text)
    names = [part["src"] for table in tables for part in json.loads(html.unescape(table))["parts"]]
    return [(site / ASSETS / PREPARED / name).read_text(encoding="ascii") for name in names]


def _article(text: str, page: Path) -> str:
    """The text of the page, its pictures inside; links to other pages are only words here."""
    start, end = text.index("<article"), text.rindex("</article>") + len("</article>")
    article = re.sub(
        r'<p class="carts-(?:teach-door|languages)".*?</p>|<div class="carts-hosted".*?</div>',
        "",
        text[start:end],
        flags=re.S,
    )
    article = re.sub(r"<a [^>]*md-content__button.*?</a>", "", article, flags=re.S)

    def picture(match: re.Match[str]) -> str:
        return f"{match[1]}{_data(_beside(page, match[2]))}{match[3]}"

    article = re.sub(r'(<img [^>]*src=")(?!data:|https?:)([^"]+)(")', picture, article)
    return re.sub(r'(<a [^>]*?)\s?href="(?!#|https?:|mailto:)[^"]*"', r"\1", article)


def _with_files(sheet: Path) -> str:
    """A style sheet with its fonts and pictures inside."""

    def inside(match: re.Match[str]) -> str:
        target = match[1].strip("\"'")
        return (
            match[0]
            if target.startswith(("data:", "#"))
            else f"url({_data(_beside(sheet, target))})"
        )

    text = sheet.read_text(encoding="utf-8")
    return re.sub(r"/\*# sourceMappingURL.*?\*/", "", re.sub(r"url\(([^)]+)\)", inside, text))


def _beside(file: Path, address: str) -> Path:
    return (file.parent / unquote(html.unescape(address)).split("?")[0].split("#")[0]).resolve()


def _data(path: Path) -> str:
    kind = "font/woff2" if path.suffix == ".woff2" else mimetypes.guess_type(path.name)[0]
    coded = base64.b64encode(path.read_bytes()).decode()
    return f"data:{kind or 'application/octet-stream'};base64,{coded}"


def _script(script: str, elsewhere: Mapping[str, str]) -> str:
    if re.search(r"</script", script, re.IGNORECASE):
        raise ValueError("a script that holds the end of a script cannot stand in a page")
    if script in elsewhere:
        return f'<script data-from="{elsewhere[script]}"></script>'
    return f"<script>{script}</script>"


def _first(pattern: str, text: str) -> str:
    found = re.search(pattern, text, re.DOTALL)
    return found[1] if found else ""
