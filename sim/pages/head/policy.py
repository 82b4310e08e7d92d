"""The Content-Security-Policies: what a page may run, show and ask for, and nothing else.

A page of a site may run what lies beside it. The inline scripts that the theme's templates write
are allowed one by one, by the SHA-256 of their text; a script that came into the page in any other
way (front matter, raw HTML in a lesson) is not. A file that must work alone has its scripts and
styles in itself, each of them allowed by its hash.
"""

from __future__ import annotations

import hashlib
import html
import re
from base64 import b64encode
from collections.abc import Iterable, Mapping
from typing import Literal

Audience = Literal["offline", "hosted", "preview"]

_EXPRESSION = re.compile(r"\{\{.*?\}\}")
_SCRIPT = re.compile(r"<script(?P<attributes>[^>]*)>(?P<text>.*?)</script>", re.DOTALL)
_DATA_TYPE = re.compile(r"""\btype\s*=\s*["']?(?!text/javascript|module)[\w/+-]+""")

_COMMON = {
    "default-src": "'none'",
    "script-src": "'self' 'wasm-unsafe-eval'",
    "style-src": "'self'",
    "img-src": "'self' data:",
    "font-src": "'self' data:",
    "connect-src": "'none'",
    "worker-src": "blob:",
    "base-uri": "'none'",
    "form-action": "'none'",
}
_HOSTED = {
    "connect-src": "'self'",
    "worker-src": "'self' blob:",
    "manifest-src": "'self'",
}
# `mkdocs serve` adds a script of its own to every page when it sends it: no hash can cover it.
_PREVIEW = {**_HOSTED, "script-src": "'self' 'wasm-unsafe-eval' 'unsafe-inline'"}


def policy_of_page(
    audience: Audience, inline_scripts: Iterable[str] = (), *, films: bool = False
) -> str:
    """The Content-Security-Policy for a page with these inline scripts; `films`: it plays some."""
    changes: dict[str, dict[str, str]] = {"offline": {}, "hosted": _HOSTED, "preview": _PREVIEW}
    rules = _COMMON | changes[audience] | ({"media-src": "'self'"} if films else {})
    if audience != "preview":
        rules["script-src"] = f"{rules['script-src']} {_named(inline_scripts)}".rstrip()
    return _joined(rules)


def policy_of_file(
    styles: Iterable[str],
    scripts: Iterable[str],
    *,
    images: str = "data:",
    fonts: str = "'none'",
    films: str = "",
    python: bool = False,
) -> str:
    """The policy of a file that has these styles and scripts in itself, as an attribute's value.

    `images`, `fonts`, `films` (empty: it has none): where they may come from; `python`: whether it
    may run here.
    """
    wasm = "'wasm-unsafe-eval' " if python else ""
    rules = {
        "default-src": "'none'",
        "script-src": wasm + _named(scripts),
        "style-src": _named(styles),
        "img-src": images,
        "font-src": fonts,
        **({"media-src": films} if films else {}),
        "worker-src": "blob:",
        "base-uri": "'none'",
        "form-action": "'none'",
    }
    return html.escape(_joined(rules), quote=True)


def _named(texts: Iterable[str]) -> str:
    """Each of these texts by its hash, as a policy names it."""
    digests = dict.fromkeys(hashlib.sha256(text.encode("utf-8")).digest() for text in texts)
    return " ".join(f"'sha256-{b64encode(digest).decode('ascii')}'" for digest in digests)


def _joined(rules: Mapping[str, str]) -> str:
    return "; ".join(f"{name} {value}" for name, value in rules.items())


def inline_scripts(page: str) -> list[str]:
    """The texts of the scripts that run from within the page; data blocks do not run."""
    return [
        match["text"]
        for match in _SCRIPT.finditer(page)
        if "src=" not in match["attributes"] and not _DATA_TYPE.search(match["attributes"])
    ]


def trusted_scripts(templates: Iterable[str]) -> list[re.Pattern[str]]:
    """The inline scripts in the sources of the theme's templates, as patterns.

    Where a template fills something in (the address of the site's root), a path may stand.
    """
    return [
        re.compile(r"[\w./:-]*".join(map(re.escape, _EXPRESSION.split(text))))
        for template in templates
        for text in inline_scripts(template)
    ]


def is_trusted(script: str, trusted: Iterable[re.Pattern[str]]) -> bool:
    """Whether an inline script is one of the theme's own."""
    return any(pattern.fullmatch(script) for pattern in trusted)
