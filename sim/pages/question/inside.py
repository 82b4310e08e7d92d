"""Markdown inside of a question: formulas, tables, pictures; no HTML of the author's own.

A question is shown in many places (page, panel, print, key), so its texts must be safe wherever
they stand: what looks like HTML is shown as it was typed.
"""

from __future__ import annotations

import re
from functools import cache

from markdown import Markdown

_ONE_PARAGRAPH = re.compile(r"<p>((?:(?!<p>).)*)</p>", re.DOTALL)
_PAGE_LINK = re.compile(r'(<a href="(?![a-z]+:|#)[^":]*)\.md(["#])')
_UNSAFE = re.compile(r'(href|src)="\s*(?!https?:|mailto:|#)[^"/?#]*:[^"]*"', re.IGNORECASE)


def to_html(text: str) -> str:
    """The text as HTML blocks."""
    if not text:
        return ""
    md = _markdown()
    md.reset()
    made = _PAGE_LINK.sub(r"\1.html\2", md.convert(text))
    return _UNSAFE.sub(r'\1="#"', made)


def to_inline(text: str) -> str:
    """The text as HTML for a line: a single paragraph without its frame."""
    made = to_html(text)
    single = _ONE_PARAGRAPH.fullmatch(made)
    return single[1] if single else made


@cache
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
    return md
