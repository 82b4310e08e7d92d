"""Text that becomes part of HTML. The standard library's `html` brings every named letter along."""

from __future__ import annotations

_LETTERS = {ord(k): v for k, v in (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"),
                                   ('"', "&quot;"), ("'", "&#x27;"))}  # fmt: skip


def escape(text: str) -> str:
    """The text with what HTML would take for its own written out."""
    return text.translate(_LETTERS)
