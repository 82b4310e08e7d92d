"""Pictures beside the items that show them: an item may name no file that its package does not
have, and a platform may refuse the whole package for one."""

from __future__ import annotations

import re
from html import unescape
from xml.sax.saxutils import escape

from sim.pages.classroom.pictures import ELSEWHERE, Pictures, numbered

_SHOWN = re.compile(r"""<img src=(["'])(.*?)\1 alt=(["'])(.*?)\3/>""")
FOLDER = "pictures"  # beside the items


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
            if ELSEWHERE.match(address):
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
            path = f"{FOLDER}/{numbered(len(self.files) + 1, address)}"
            self._paths[address], self.files[path] = path, content
        return self._paths[address]
