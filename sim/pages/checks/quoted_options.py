"""Questions of which every answer stands in the quotes of a word processor: students read them.

One answer alone may be a saying, and so may all of them, where they are whole sentences.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from sim.pages.findings import Finding
from sim.pages.text.fence_scan import scan
from sim.pages.text.plain_lines import lines_of
from sim.pages.text.yaml.source import KeyPath, YamlError, load

_QUOTED = re.compile(r"“[^“”]*”|„[^“”]*[“”]|‘[^‘’]*’|«[^«»]*»")
_SAYING = re.compile(r".*[.!?…。！？]")
_LISTS = ("options", "choice")


def quoted_options(text: str, file: str) -> Iterator[Finding]:
    """A warning at the first answer of each."""
    lines = lines_of(text)
    for block in scan(lines):
        if not _QUOTED.search(block.body):
            continue
        try:
            source = load(block.body, first_line=block.start + 2, first_col=block.body_indent + 1)
        except YamlError:
            continue
        for asked in _answers(source.plain):
            said = [words[1:-1] for words in asked.values()]
            line, col = source.place(next(iter(asked)))
            begun = lines[line - 1][col - 1 :]  # by a straight quote, where it was meant
            if not all(map(_QUOTED.fullmatch, asked.values())) or not _QUOTED.match(begun):
                continue
            if len(said) > 1 and not all(map(_SAYING.fullmatch, said)):
                told = f"the quotes {begun[0]} around every answer would be shown as a part of it"
                hint = f"write it without them, or in straight quotes: {said[0].strip()[:60]}"
                yield Finding(file, line, col, "typographic-quotes", told, hint, "warning")


def _answers(plain: object, path: KeyPath = ()) -> Iterator[dict[KeyPath, str]]:
    """Of each list of answers in a block the texts, by where they stand."""
    listed = isinstance(plain, list) and path[-1:] and path[-1] in _LISTS
    texts: dict[KeyPath, str] = {}
    inside = enumerate(plain) if isinstance(plain, list) else ()
    for key, value in plain.items() if isinstance(plain, dict) else inside:
        at = (*path, key)
        if listed and isinstance(value, str):
            texts[at] = value
        elif listed and isinstance(value, dict) and isinstance(value.get("text"), str):
            texts[*at, "text"] = value["text"]
        else:
            yield from _answers(value, at)
    if texts:
        yield texts
