"""Addresses of our scripts and styles on a web server end in a stamp of what they hold.

A browser that kept `carts.js` from the version before would else run it in a page of this one. With
`carts.js?1f2e3d4c` it may keep each for ever: a changed file has another address. The parts of the
runtime have their hash in their names; its table of contents is asked for with the stamp of the
script that asks, so that stamp covers both.
"""

from __future__ import annotations

import hashlib
import re
from functools import cache
from pathlib import Path
from urllib.parse import unquote

OURS = "assets/carts/"
INDEX = OURS + "runtime/index.js"
BESIDE = {OURS + "measured.js": OURS + "film.js", OURS + "carts.js": OURS + "proof.js"}
"""What a script asks for by its own stamp when a reader wants it."""

DIGITS = 10  # of a sha256 in hexadecimal

# What leads to the folder is `../`; in 404.html, which is served anywhere, the path of the site.
_ADDRESS = re.compile(rf'(\s(?:src|href|data-lesson)="(?:[^":?#]*/)?({OURS}[^"?#]+\.(?:js|css)))"')


def stamp_pages(site: Path) -> None:
    """Write the stamps into all pages of the built site; a page that has them stays as it is."""

    @cache
    def stamp(name: str) -> str:
        return stamp_of(site, name)

    def stamped(found: re.Match[str]) -> str:
        name = unquote(found[2])  # a lesson may be called “Stoß #1”
        return f'{found[1]}?{stamp(name)}"' if (site / name).is_file() else found[0]

    for page in site.rglob("*.html"):
        text = page.read_bytes().decode("utf-8")
        page.write_bytes(_ADDRESS.sub(stamped, text).encode("utf-8"))


def stamp_of(site: Path, name: str) -> str:
    """The stamp of the file `name`; a script's changes with what it loads, too."""
    held = hashlib.sha256((site / name).read_bytes())
    if (beside := BESIDE.get(name)) and (site / beside).is_file():
        held.update((site / beside).read_bytes())
    if name.endswith(".js") and (site / INDEX).is_file():
        held.update((site / INDEX).read_bytes())
    return held.hexdigest()[:DIGITS]
