"""Pictures that questions show, as a file for a learning platform takes them along."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from urllib.parse import unquote

Pictures = Callable[[str], bytes | None]
"""What a picture of a site holds, by its address in a question; None: it is not there."""

SHOWN = re.compile(r'(?P<before><img\b[^>]*?\bsrc=")(?P<address>[^"]*)"')
"""A picture in the HTML of a question."""

ELSEWHERE = re.compile(r"[a-z][a-z0-9+.-]*:|//", re.IGNORECASE)
_PLAIN = re.compile(r"[^A-Za-z0-9.]+")
_ENDINGS = (".png", ".jpg", ".jpeg", ".gif", ".svg", ".webp")


def no_pictures(_: str) -> None:
    """For questions from nowhere."""


def pictures_of(folder: Path, site: Path) -> Pictures:
    """Pictures named from `folder`; what does not lie in `site` is not handed on."""

    @cache  # asked for when the package is made, and when what is lost is told
    def read(address: str) -> bytes | None:
        if ELSEWHERE.match(address):
            return None
        file = (folder / unquote(address)).resolve()
        inside = file.is_relative_to(site.resolve()) and file.suffix.lower() in _ENDINGS
        return file.read_bytes() if inside and file.is_file() else None

    return read


def numbered(count: int, address: str) -> str:
    """A name for the picture, plain and with a number: two folders may have the same name."""
    return f"{count}-{_PLAIN.sub('-', unquote(address).rpartition('/')[2])}"
