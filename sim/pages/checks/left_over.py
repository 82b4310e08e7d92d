"""What stands in a lesson because nobody looked again, and what students would read: words of the
starter that were to be replaced, quotes that a word processor put around a text.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from sim.pages.findings import Finding

PLACEHOLDERS = (
    "What this lesson is about, in one sentence.",
    "Say in two or three sentences what the problem is. Nobody needs to know the answer yet.",
)
"""Of the lesson with which `carts new` begins."""

_KEYS = "ask|title|description|explain"  # what nobody says aloud; answers: see quoted_options
_QUOTED = re.compile(
    rf"^(?P<key>[ \t]*(?:- +)*(?:{_KEYS}):[ \t]+|[^\"'\n]*[{{,][ \t]*(?:{_KEYS}):[ \t]+)"
    r"(?P<text>“[^“”\n]*”|„[^“”\n]*[“”]|‘[^‘’\n]*’|«[^«»\n]*»)[ \t]*(?:$|[,}])",
    re.MULTILINE,
)


def left_over(text: str, file: str, found: Iterable[Finding]) -> list[Finding]:
    """A warning for each, which stops nothing, but where something was `found` in its line."""
    told = {one.line for one in found}
    made = []
    for at, code, message, hint in sorted([*_placeholders(text), *_quotes(text)]):
        line, col = text.count("\n", 0, at) + 1, at - text.rfind("\n", 0, at)
        if line not in told:
            made.append(Finding(file, line, col, code, message, hint, "warning"))
    return made


def _placeholders(text: str) -> Iterator[tuple[int, str, str, str]]:
    for words in PLACEHOLDERS:
        if (at := text.find(words)) >= 0:
            message = f"students will read “{words[:43]}{'…' * (len(words) > 43)}”"
            hint = "put your own words here; a lesson that you do not need: delete its file"
            yield at, "placeholder", message, hint


def _quotes(text: str) -> Iterator[tuple[int, str, str, str]]:
    for one in _QUOTED.finditer(text):
        quotes = f"{one['text'][0]} {one['text'][-1]}"
        message = f"the quotes {quotes} around this text would be shown as a part of it"
        hint = f"write it without them: {one['text'][1:-1][:60]}"
        if re.search(r": | #|,|^[\W]", one["text"][1:-1]):
            hint = f'write straight quotes: "{one["text"][1:-1][:60]}"'
        yield one.start("text"), "typographic-quotes", message, hint
