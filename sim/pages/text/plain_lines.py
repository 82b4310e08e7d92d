"""The lines of a lesson as editors count them, and its text without its code.

Python's `splitlines` also ends a line at signs that nobody sees and that Word and PDF files are
full of (U+2028, vertical tab, form feed). Markdown and editors do not: a place behind one would be
off.
"""

from __future__ import annotations

import re

from sim.pages.text.fence_scan import meant_kind

BOM = "\ufeff"
_LINE = re.compile(r"([^\r\n]*)(\r\n|\r|\n|\Z)")
_FENCE = re.compile(r"^[ \t>]*(`{3,}|~{3,})[ \t]*([^`\n]*)$", re.MULTILINE)
_INLINE_CODE = re.compile(r"(`+)(?!`).+?(?<!`)\1(?!`)")


def lines_of(text: str, *, keepends: bool = False) -> list[str]:
    """The lines of a text, which end with it or at \\n, \\r\\n or \\r and at nothing else.

    Without their ends also without the mark that some editors put before a text (BOM): teacher mode
    keeps it, all others have taken it off when they read the file.
    """
    found = [line for line in _LINE.finditer(text) if line[0]]
    if keepends:
        return [line[0] for line in found]
    return [line[1] if line.start() else line[1].removeprefix(BOM) for line in found]


def without_code(text: str) -> str:
    """The text with code blanked out, so that every place stays where it is. Our blocks stay. Its
    lines end with \\n, as those of a file that was read as text."""
    kept = list(text)
    at = 0
    while opened := _FENCE.search(text, at):
        fence = re.escape(opened[1][0]) + "{" + str(len(opened[1])) + ",}"
        closing = re.compile(rf"^[ \t>]*{fence}[ \t]*$", re.MULTILINE)
        closed = closing.search(text, opened.end())
        end = closed.end() if closed else len(text)
        if not meant_kind(opened[2].strip().partition(" ")[0]):
            kept[opened.start() : end] = (
                c if c == "\n" else " " for c in text[opened.start() : end]
            )
        at = max(end, opened.end())
    return _INLINE_CODE.sub(lambda code: " " * len(code[0]), "".join(kept))
