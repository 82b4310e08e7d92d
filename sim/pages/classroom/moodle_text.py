"""Texts as Moodle's formats hold them."""

from __future__ import annotations

import re
from base64 import b64encode
from html import unescape
from xml.sax.saxutils import quoteattr

from sim.pages.classroom.pictures import SHOWN, Pictures, numbered

LONGEST = 255
"""Letters of a category's name, and of a line in a list to choose from."""

_MARK = re.compile("<[^>]*>")
_PICTURE = re.compile(r'<img\b[^>]*?\balt="([^"]*)"[^>]*>')


def category(title: str) -> str:
    """The path of a category of this name; a single slash would make a category in it."""
    name = " ".join(title.split())[:LONGEST].rstrip()
    return f"$course$/top/{name.replace('/', '//')}"


def literal(text: str) -> str:
    """A short answer as typed: Moodle takes a bare star for anything."""
    return text.replace("*", "\\*")


def plain_text(html: str) -> str:
    """What a list to choose from can show: it holds no marks of HTML, of a picture its words."""
    return unescape(_MARK.sub("", _PICTURE.sub(r"\1", html)))


def cdata(content: str) -> str:
    """A text as it is: of an escaped one Moodle's reader drops blanks between two such signs."""
    return "<![CDATA[" + content.replace("]]>", "]]]]><![CDATA[>") + "]]>"


def text_and_files(html: str, pictures: Pictures) -> str:
    """The text, and after it the pictures that it shows."""
    names: dict[str, str] = {}
    files = []

    def shown(found: re.Match[str]) -> str:
        address = unescape(found["address"])
        if address not in names and (content := pictures(address)) is not None:
            name = names[address] = numbered(len(names) + 1, address)
            encoded = b64encode(content).decode("ascii")
            files.append(
                f'<file name={quoteattr(name)} path="/" encoding="base64">{encoded}</file>'
            )
        if address not in names:
            return found[0]
        return f'{found["before"]}@@PLUGINFILE@@/{names[address]}"'

    text = SHOWN.sub(shown, html)
    return f"<text>{cdata(text)}</text>{''.join(files)}"
