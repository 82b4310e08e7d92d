"""Lessons of one title: the menu shows the same entry twice, and nobody knows which is which."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sim.pages.checks.markdown_slips import running_text
from sim.pages.findings import Finding
from sim.pages.language import language_folder
from sim.pages.text.front_matter import AT_THE_TOP

_STATED = re.compile(AT_THE_TOP + r"title:[ \t]*(?=[^\s#>|])", re.MULTILINE)
_HEADING = re.compile(r"^# +(?=\S)", re.MULTILINE)
_BEHIND = re.compile(r"[ \t](?:#+|\{[^{}]*\})$")  # marks that close a heading, its id


def title_twice(text: str, file: str, titles: dict[str, str]) -> Iterator[Finding]:
    """That a lesson is called as another of its language. `titles`: the places of those that were
    looked at, by title; this one's is added."""
    stated = _STATED.match(text) or _HEADING.search(running_text(text))
    if not stated:
        return
    begin = stated.end()
    title = _BEHIND.sub("", text[begin:].partition("\n")[0].rstrip()).strip("\"'")
    line, col = text.count("\n", 0, begin) + 1, begin - text.rfind("\n", 0, begin)
    first = titles.setdefault(f"{language_folder(file)}/{title}", f"{file}:{line}")
    if first != f"{file}:{line}":
        told = f"the menu would show “{title[:40]}” twice: {first} is called the same"
        hint = "give one of the two lessons another title"
        yield Finding(file, line, col, "title-taken", told, hint, "warning")
