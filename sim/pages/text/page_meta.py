"""What the front matter of a page tells the theme: texts that are safe, lessons found first."""

from __future__ import annotations

from collections.abc import MutableMapping
from html import escape
from typing import Any

LESSON_FIRST = 4
"""Of the search: how much more a hit in a lesson counts than one in its teacher's page, which
has the same title and fewer words. Whoever searches a law looks for the lesson."""


def tell_theme(meta: MutableMapping[str, Any], *, lesson: bool) -> None:
    """Change the front matter in place, before the theme reads it. What an author says wins."""
    for key in ("title", "description", "author"):  # the theme writes them out as they are
        if isinstance(meta.get(key), str):
            meta[key] = escape(meta[key])
    search = meta.get("search", {})
    if lesson and isinstance(search, dict):
        meta["search"] = {"boost": LESSON_FIRST, **search}
