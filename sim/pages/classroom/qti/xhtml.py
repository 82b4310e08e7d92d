"""HTML of a question as the XHTML that may stand in a QTI item; whatever else there is, its text.

Formulas stay as they are written, TeX between `\\(` and `\\)`.
"""

from __future__ import annotations

import re
from html.parser import HTMLParser
from xml.sax.saxutils import escape, quoteattr

BLOCKS = frozenset({"p", "div", "ul", "ol", "blockquote", "pre", "table", "h1", "h2", "h3", "h4",
                    "h5", "h6", "hr"})  # fmt: skip
ALLOWED = BLOCKS | {"em", "strong", "b", "i", "code", "sub", "sup", "span", "br", "li", "a", "img",
                    "thead", "tbody", "tr", "th", "td"}  # fmt: skip
EMPTY = frozenset({"br", "img", "hr"})
ATTRIBUTES = {"a": ("href",), "img": ("src", "alt"), "th": ("colspan", "rowspan"),
              "td": ("colspan", "rowspan")}  # fmt: skip

_FORBIDDEN = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ud800-\udfff\ufffe\uffff]")


def xml_text(text: str) -> str:
    """Text as XML holds it."""
    return escape(_FORBIDDEN.sub("", text))


def xml_attribute(text: str) -> str:
    """The value of an attribute, with its quotation marks."""
    return quoteattr(_FORBIDDEN.sub("", text))


def flow(html: str) -> str:
    """Blocks and lines in any order, as in a choice."""
    made = _Reader()
    made.feed(html)
    made.close()
    return "".join(made.parts) + "".join(f"</{name}>" for name in reversed(made.open))


def blocks(html: str) -> str:
    """Blocks only, as in the body of an item: a line becomes a paragraph."""
    found = flow(html).strip()
    first = re.match(r"<([a-z0-9]+)", found)
    if not found or (first and first[1] in BLOCKS):
        return found
    return f"<p>{found}</p>"


class _Reader(HTMLParser):
    """Writes every tag that it knows again, closed in the right order."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.parts: list[str] = []
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in ALLOWED:
            return
        given = {name: value or "" for name, value in attrs}
        if tag == "img":
            given.setdefault("alt", "")
        kept = "".join(
            f" {name}={xml_attribute(given[name])}"
            for name in ATTRIBUTES.get(tag, ())
            if name in given
        )
        self.parts.append(f"<{tag}{kept}{'/' if tag in EMPTY else ''}>")
        if tag not in EMPTY:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        if tag in self.open:
            while (last := self.open.pop()) != tag:
                self.parts.append(f"</{last}>")
            self.parts.append(f"</{tag}>")

    def handle_data(self, data: str) -> None:
        self.parts.append(xml_text(data))
