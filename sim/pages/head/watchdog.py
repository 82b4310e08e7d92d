"""The script in every page's head that says when our scripts do not run: missing, cut, too new.

It stands in the page itself, in JavaScript that a browser of 2010 reads, and is allowed by its
hash. Fields are closed in the page as it is written; only our scripts open them. So where they do
not run nothing can be typed that would be lost, and the page says why.
"""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import sim
from sim.pages.language import mark, tr

_SCRIPT = Path(sim.__file__).parent / "web" / "site" / "watchdog.js"
_WORDS = {
    "missing": mark(
        "A part of this page is missing: nothing works here, and nothing you type is kept. "
        "If you opened the page inside a zip, unpack the whole zip first; "
        "else copy the whole folder again."
    ),
    "broken": mark(
        "This page does not work here, and nothing you type is kept: this browser is too old, "
        "or a file of the page is damaged. Try a newer browser, or copy the whole folder again."
    ),
    "part": mark(
        "A part of this page is missing or damaged and does not work; your answers are kept. "
        "Copy the whole folder again."
    ),
    # On a page of a web server there is no folder to copy.
    "missing web": mark(
        "A part of this page did not come: nothing works here, and nothing you type is kept. "
        "The network was interrupted, or this site was renewed: load the page again."
    ),
    "broken web": mark(
        "This page does not work here, and nothing you type is kept: this browser is too old, "
        "or a file of the page is damaged. Load the page again, or try a newer browser."
    ),
    "part web": mark(
        "A part of this page did not come and does not work; your answers are kept. "
        "Load the page again."
    ),
    # A lesson in one file has neither a folder nor other files.
    "broken alone": mark(
        "This page does not work here, and nothing you type is kept: this browser is too old, "
        "or the file is damaged. Get the file again, or try a newer browser."
    ),
    "part alone": mark(
        "A part of this file is damaged and does not work; your answers are kept. "
        "Get the file again."
    ),
    "slow": mark("This page is still loading. Nothing you type is kept before it is there."),
}
_IN_A_SITE = {name: name for name in _WORDS if not name.endswith(" alone")}
_ALONE = {"broken": "broken alone", "part": "part alone", "slow": "slow"}


def watchdog(*, alone: bool = False) -> str:
    """The script, in the language that is being written now; `alone`: for a lesson in one file."""
    names = _ALONE if alone else _IN_A_SITE
    told = {name: tr(_WORDS[words]) for name, words in names.items()}
    return _source().replace('"@@WORDS@@"', json.dumps(told, ensure_ascii=False), 1)


@cache
def _source() -> str:
    return _SCRIPT.read_text(encoding="utf-8")
