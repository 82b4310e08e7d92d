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
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from sim.pages.findings import Finding
from sim.pages.head.policy import policy_of_file
from sim.pages.head.watchdog import watchdog
from sim.pages.language import ENGLISH, mark, of_page, speaking, words
from sim.pages.prepared import FOLDER as PREPARED
from sim.pages.single.all_inside import INSIDE
from sim.pages.single.beside import Beside, is_far
from sim.pages.site.files import ASSETS, FILM
from sim.pages.text.films import plays_films

_LOOK = """\
html { font-size: 125%; } body { margin: 0; }
main, details.carts-about { margin: 0 auto; max-width: 42rem; padding: 0 0.8rem;
  width: 100%; box-sizing: border-box; }
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
_SHOWN = "img|video|audio|source"
_NOTHING = "data:,"  # in the place of a picture that the site has not: its words are shown
_MADE = mark("Made with Newton's Carts. Licences")
_PAGE = """\
<!doctype html>
<html lang="{language}" class="{kinds}"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="carts-site" content="{site_id}"><meta name="carts-page" content="{page_id}">{teacher}
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
    lesson: str,
    site: Path,
    runtime: Iterable[str],
    report: Callable[[Finding], None],
    elsewhere: Mapping[str, str] | None = None,
) -> str:
    """The file for the page of `lesson`; `runtime`: scripts of one that has what the page needs.

    `report` is told of what the page names and the site has not: the file is without it.
    `elsewhere`: scripts that are put in later, with their addresses: `data-from` names them.
    """
    beside = Beside(site, lesson, report)
    page = beside.page
    text = page.read_text(encoding="utf-8")
    sheets = re.findall(r'<link rel="stylesheet" href="(.+?)"', text)
    found = (beside.at(page, href) for href in sheets if not is_far(href))
    styles = [_LOOK, *(_with_files(sheet, beside) for sheet in found if sheet)]
    ours = re.findall(rf'<script src="([^"]*{ASSETS}[^"]+)"', text)
    sources = [
        src for src in dict.fromkeys(ours) if not any(name in src for name in _ONLY_IN_A_SITE)
    ]
    live = any(src.endswith(_WITH_PYTHON) for src in sources)
    scripts = [_DARK, INSIDE, *(runtime if live else ()), *_prepared(text, beside)]
    for script in (beside.at(page, src) for src in sources):
        if script and script.name == "measured.js":  # in one file nothing is asked for later
            scripts.append(script.with_name(FILM).read_text(encoding="utf-8"))
        if script:
            scripts.append(script.read_text(encoding="utf-8"))
    data = re.findall(r'<script type="application/json" id="carts-lesson">.*?</script>', text, re.S)
    licences = (site / "third-party-licenses.txt").read_text(encoding="utf-8")
    article = _article(text, beside)
    language = _first(r'<html lang="([^"]*)"', text) or ENGLISH
    said = words(of_page(None, "", language))
    with speaking(said):  # its class closes what waits for a run, as in the site
        watching = watchdog(alone=True)
    return _PAGE.format(
        language=language,
        made=html.escape(said.get(_MADE, _MADE), quote=False),
        watching=watching,
        kinds=_first(r'<html [^>]*class="no-js *([^"]*)"', text),
        policy=policy_of_file(
            styles,
            [watching, *scripts],
            images="data: blob:",
            fonts="data:",
            films="data:" if plays_films(article) else "",
            python=True,
        ),
        site_id=_first(r'name="carts-site" content="([^"]*)"', text),
        teacher=_first(r'(<meta name="carts-teacher" content="[^"]*">)', text),
        page_id=_first(r'name="carts-page" content="([^"]*)"', text),
        title=_first(r"<title>(.*?)</title>", text),
        styles="\n".join(f"<style>{style}</style>" for style in styles),
        article=article,
        licences=html.escape(licences),
        data="\n".join(data),
        scripts="\n".join(_script(script, elsewhere or {}) for script in scripts),
    )


def _prepared(text: str, beside: Beside) -> list[str]:
    """The scripts with the runs that were prepared for the scenes of the page."""
    tables = re.findall(r'<carts-scene[^>]* data-prepared="([^"]*)"', text)
    names = [part["src"] for table in tables for part in json.loads(html.unescape(table))["parts"]]
    folder = beside.site / ASSETS / PREPARED
    found = (beside.at(folder / "here", str(name)) for name in names)
    return [script.read_text(encoding="utf-8") for script in found if script]


def _article(text: str, beside: Beside) -> str:
    """The text of the page, its pictures inside; links to other pages are only words here."""
    start, end = text.index("<article"), text.rindex("</article>") + len("</article>")
    article = re.sub(
        r'<p class="carts-(?:teach-door|languages)".*?</p>|<div class="carts-hosted".*?</div>',
        "",
        text[start:end],
        flags=re.S,
    )
    article = re.sub(r"<a [^>]*md-content__button.*?</a>", "", article, flags=re.S)
    article = re.sub(r'(<span class="carts-film-words">[^<]*?)(?: · )?<a .*?</a>', r"\1", article)

    def picture(match: re.Match[str]) -> str:
        if is_far(match[2]):
            return match[0]
        file = beside.at(beside.page, match[2])
        return f"{match[1]}{_data(file) if file else _NOTHING}{match[3]}"

    article = re.sub(r'(<img [^>]*?)\ssrcset="[^"]*"', r"\1", article)  # one of them is enough
    article = re.sub(rf'(<(?:{_SHOWN})\b[^>]*?\s(?:src|poster)=")([^"]+)(")', picture, article)
    return re.sub(r'(<a [^>]*?)\s?href="(?!#|https?:|mailto:)[^"]*"', r"\1", article)


def _with_files(sheet: Path, beside: Beside) -> str:
    """A style sheet with its fonts and pictures inside."""

    def inside(match: re.Match[str]) -> str:
        target = match[1].strip().strip("\"'")
        if target.startswith("#") or is_far(target):
            return match[0]
        file = beside.at(sheet, target)
        return f"url({_data(file) if file else _NOTHING})"

    text = sheet.read_text(encoding="utf-8")
    return re.sub(r"/\*# sourceMappingURL.*?\*/", "", re.sub(r"url\(([^)]+)\)", inside, text))


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
