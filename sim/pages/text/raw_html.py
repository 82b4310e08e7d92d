"""What a lesson holds that its page will not show: pictures and frames from elsewhere, scripts.

The build names them too, once a page is made. Here they have a line, and what to write in their
place.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from sim.pages.text.blocked import blocked
from sim.pages.text.front_matter import Found

_TAG = re.compile(r"<(?P<name>[a-zA-Z][\w-]*)(?:\s(?:[^<>\"']|\"[^\"]*\"|'[^']*')*)?/?>")
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_SOURCE = re.compile(r"\bsrc\s*=\s*(?:\"([^\"]*)\"|'([^']*)'|([^\s>]+))", re.IGNORECASE)
_PICTURE_ELSEWHERE = re.compile(
    r"!\[[^\]\n]*\]\([ \t]*<?(?P<at>(?:https?:)?//[^\s)>]*)", re.IGNORECASE
)
SHOWN = 60
SHOWING = ("img", "video", "audio", "source")

PICTURE = "save it beside the lesson and write its name: ![two carts, one at rest](carts.png)"
LINK = "a page loads nothing from elsewhere: write a link, [the film](https://example.org/film)"
FILM = f"save the film beside the lesson, ![what it shows](film.mp4); or {LINK.partition(': ')[2]}"
SCRIPT = "delete it: no script of a lesson runs"
STYLE = "delete it: colours and sizes are those of the site"
HINTS = {
    **{"img": PICTURE, "script": SCRIPT, "style": STYLE, "base": "delete it"},
    **dict.fromkeys(("video", "source", "iframe"), FILM),
}
"""By the tag; another one that shows something is an object or a sound."""


def never_shown(prose: str) -> Iterator[Found]:
    """Each tag and picture that the page's policy blocks."""
    prose = without_comments(prose)
    for picture in _PICTURE_ELSEWHERE.finditer(prose):
        told = f"the page will not show a picture from elsewhere: {picture['at'][:SHOWN]}"
        yield picture.start(), "blocked", told, PICTURE
    for tag in _TAG.finditer(prose):
        what = blocked(tag[0])
        if what:
            yield (
                tag.start(),
                "blocked",
                f"the page will not show this: {tag[0][:SHOWN]}",
                _hint(tag["name"].lower(), what),
            )


def pictures_in_html(prose: str) -> Iterator[tuple[int, str]]:
    """Where a picture or a film in HTML stands, and its address."""
    for tag in _TAG.finditer(without_comments(prose)):
        source = _SOURCE.search(tag[0]) if tag["name"].lower() in SHOWING else None
        address = next(filter(None, source.groups()), "") if source else ""
        if address:
            yield tag.start(), address


def without_comments(prose: str) -> str:
    """The text with comments blanked out, so that every place stays where it is."""
    return _COMMENT.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), prose)


def _hint(tag: str, what: list[str]) -> str:
    first = what[0]
    if first.startswith("style="):
        return STYLE
    if first.startswith("on") or "javascript:" in first:
        return SCRIPT
    return HINTS.get(tag, LINK)
