"""Markdown inside of a question: formulas, tables, pictures; no HTML of the author's own.

A question is shown in many places (page, panel, print, key), so its texts must be safe wherever
they stand: what looks like HTML is shown as it was typed.
"""

from __future__ import annotations

import re
from functools import cache, lru_cache
from html import unescape
from xml.etree.ElementTree import Element

from markdown import Markdown
from markdown.treeprocessors import Treeprocessor
from markdown.util import AMP_SUBSTITUTE

from sim.pages.text.films import show_films

_LAST = -5  # when all addresses are made

_OF_SEVERAL_LINES = ("code", "hashheader", "hr", "indent", "olist", "quote", "reference", "ulist")
"""What a sign at the beginning of a text makes of it."""

_ONE_PARAGRAPH = re.compile(r"<p>((?:(?!<p>).)*)</p>", re.DOTALL)
_PAGE_LINK = re.compile(r'(<a href="(?![a-z]+:|#)[^":]*)\.md(["#])')
_SCHEME = re.compile(r"([a-z][a-z0-9+.-]*):", re.IGNORECASE)
_SAFE = ("http", "https", "mailto")


@lru_cache(maxsize=4096)  # a question's texts are the same after an edit elsewhere in its lesson
def to_html(text: str) -> str:
    """The text as HTML blocks.

    What is written in one line is one: `- 0.4 m/s` is a velocity and no list without its sign.
    """
    if not text:
        return ""
    md = _blocks() if "\n" in text.strip() else _line()
    md.reset()
    return _PAGE_LINK.sub(r"\1.html\2", md.convert(text))


def to_inline(text: str) -> str:
    """The text as HTML for a line: a single paragraph without its frame."""
    made = to_html(text)
    single = _ONE_PARAGRAPH.fullmatch(made)
    return single[1] if single else made


@cache
def _blocks() -> Markdown:
    return _markdown()


@cache
def _line() -> Markdown:
    md = _markdown()
    for block in _OF_SEVERAL_LINES:
        md.parser.blockprocessors.deregister(block)
    return md


def _markdown() -> Markdown:
    md = Markdown(
        extensions=["pymdownx.arithmatex", "tables", "sane_lists"],
        extension_configs={
            "pymdownx.arithmatex": {"generic": True},
            "tables": {"use_align_attribute": True},
        },
    )
    md.preprocessors.deregister("html_block")
    md.inlinePatterns.deregister("html")
    md.treeprocessors.register(_SafeAddresses(md), "carts_safe_addresses", _LAST)
    return md


class _SafeAddresses(Treeprocessor):
    """Takes addresses away that a browser would run: javascript:, data: and their like."""

    def run(self, root: Element) -> None:
        for element in root.iter():
            for name in ("href", "src"):
                address = element.get(name)
                if address is not None and not _is_safe(address):
                    element.attrib.pop(name)
        show_films(root)


def _is_safe(address: str) -> bool:
    # What a browser makes of it: entities read, white space and control characters left out.
    plain = unescape(address.replace(AMP_SUBSTITUTE, "&"))
    scheme = _SCHEME.match("".join(c for c in plain if c.isprintable() and not c.isspace()))
    return scheme is None or scheme[1].lower() in _SAFE
