"""Texts that a page shows as they are typed: heads and cells of a table, boxes of a diagram, words
to use and the beginning of a sentence. A formula in one would be read as backslashes."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from sim.scene.problem import Path, Problem

KEYS = ("columns", "rows", "objects", "words", "start")
_MARKS = re.compile(r"\\\(|\\\[|\*\*\S|!?\[[^\]]*\]\(")
_HINT = "write it with plain words and signs: v in m/s, mass of cart A, m₁"


def unformatted(
    table: Mapping[str, Any], path: Path, problems: list[Problem], keys: tuple[str, ...] = KEYS
) -> None:
    """A problem at the first text under each of these keys that has a formula, a picture or marks
    of Markdown in it."""
    for name in keys:
        for place, text in _texts(table.get(name), (*path, name)):
            if _MARKS.search(text):
                message = "no formula, picture or bold word is shown here, only what is typed"
                problems.append(Problem(place, "not-text", message, _HINT))
                break


def _texts(entry: object, path: Path) -> Iterator[tuple[Path, str]]:
    if isinstance(entry, str):
        yield path, entry
    elif isinstance(entry, (list, tuple)):
        for k, item in enumerate(entry):
            yield from _texts(item, (*path, k))
