"""Pictures beside the items that show them: an item may name no file that its package does not
have, and a platform may refuse the whole package for one."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from html import unescape
from pathlib import Path
from urllib.parse import unquote
from xml.sax.saxutils import escape

Pictures = Callable[[str], bytes | None]
"""What a picture of a site holds, by its address in a question; None: it is not there."""

_SHOWN = re.compile(r"""<img src=(["'])(.*?)\1 alt=(["'])(.*?)\3/>""")
_ELSEWHERE = re.compile(r"[a-z][a-z0-9+.-]*:|//", re.IGNORECASE)
_PLAIN = re.compile(r"[^A-Za-z0-9.]+")
_ENDINGS = (".png", ".jpg", ".jpeg", ".gif", ".svg", ".webp")
FOLDER = "pictures"  # beside the items


def no_pictures(_: str) -> None:
    """For questions from nowhere."""


def pictures_of(folder: Path, site: Path) -> Pictures:
    """Pictures named from `folder`; what does not lie in `site` is not handed on."""

    @cache  # asked for when the package is made, and when what is lost is told
    def read(address: str) -> bytes | None:
        if _ELSEWHERE.match(address):
            return None
        file = (folder / unquote(address)).resolve()
        inside = file.is_relative_to(site.resolve()) and file.suffix.lower() in _ENDINGS
        return file.read_bytes() if inside and file.is_file() else None

    return read


class Packed:
    """The pictures of a package: `files` by their path from the items."""

    def __init__(self, pictures: Pictures) -> None:
        self.files: dict[str, bytes] = {}
        self._read = pictures
        self._paths: dict[str, str] = {}

    def item(self, xml: str) -> tuple[str, list[str]]:
        """The item with its pictures, and their paths; of one that is not there, its words."""
        used: dict[str, None] = {}

        def shown(found: re.Match[str]) -> str:
            address = unescape(found[2])
            if _ELSEWHERE.match(address):
                return found[0]
            path = self._path(address)
            if path is None:
                return escape(unescape(found[4]))
            used[path] = None
            return f'<img src="{path}" alt={found[3]}{found[4]}{found[3]}/>'

        return _SHOWN.sub(shown, xml), list(used)

    def _path(self, address: str) -> str | None:
        if address not in self._paths:
            content = self._read(address)
            if content is None:
                return None
            name = _PLAIN.sub("-", unquote(address).rpartition("/")[2])
            path = f"{FOLDER}/{len(self.files) + 1}-{name}"  # two folders may have the same name
            self._paths[address], self.files[path] = path, content
        return self._paths[address]
