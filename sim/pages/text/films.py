"""Films in a lesson, written as a picture is: `![a cart bumps into another](bump.mp4)`.

The browser plays them with its own controls, and fetches no more than the first picture before a
reader asks for it. Below stands what the film shows, for paper and for who cannot see it, and a
link to the file: where a browser cannot play it, another program can.
"""

from __future__ import annotations

import re
from xml.etree.ElementTree import Element, SubElement

FILMS = (".mp4", ".webm")
"""What all browsers of today play (MP4 with H.264, as phones write it where they are asked to)."""

OTHER_FILMS = (
    *(".mov", ".m4v", ".avi", ".mkv", ".wmv", ".mpg", ".mpeg", ".3gp", ".ogv", ".flv", ".mts"),
)
"""What some play, or none."""

_PLAYS = re.compile(r"<(?:video|audio)\b", re.IGNORECASE)
_OF_PICTURE = ("width", "height", "title")


def is_film(address: str) -> bool:
    """Whether the address of a picture is that of a film."""
    return address.split("#", maxsplit=1)[0].split("?", maxsplit=1)[0].lower().endswith(FILMS)


def plays_films(html: str) -> bool:
    """Whether a page plays a film or a sound, written in whatever way."""
    return _PLAYS.search(html) is not None


def show_films(root: Element, link: str = "") -> None:
    """Pictures that are films become films. `link`: words that lead to the file; empty: none."""
    for picture in [one for one in root.iter("img") if is_film(one.get("src") or "")]:
        address, words = picture.get("src") or "", picture.get("alt") or ""
        kept = {name: picture.attrib[name] for name in _OF_PICTURE if name in picture.attrib}
        picture.attrib.clear()
        picture.tag = "span"
        picture.set("class", "carts-film-shown")
        SubElement(
            picture,
            "video",
            {
                **{"src": address, "controls": "", "preload": "metadata", "playsinline": ""},
                **({"aria-label": words} if words else {}),
                **kept,
            },
        )
        below = SubElement(picture, "span", {"class": "carts-film-words"})
        below.text = f"{words} · " if link and words else words
        if link:
            SubElement(below, "a", {"href": address}).text = link
