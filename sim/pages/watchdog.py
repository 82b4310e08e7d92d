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
    "slow": mark("This page is still loading. Nothing you type is kept before it is there."),
}


def watchdog() -> str:
    """The script, in the language that is being written now."""
    told = {name: tr(words) for name, words in _WORDS.items()}
    return _source().replace('"@@WORDS@@"', json.dumps(told, ensure_ascii=False), 1)


@cache
def _source() -> str:
    return _SCRIPT.read_text(encoding="utf-8")
