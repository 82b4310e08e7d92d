"""The one line of a list that lacks its “- ”: YAML breaks off at the next line, which has one."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

_KEY = re.compile(r"(?P<indent> *)(?:- +)?[\w.-]+:\s*(?:#.*)?")
_OPEN, _CLOSED = "[{", "]}"


def no_dash(lines: Sequence[str], near: int) -> tuple[int, int, str, str] | None:
    """Line and column (from 0), message and hint, where a list around line `near` has lines with a
    dash and one without."""
    for start, line in enumerate(lines[: near + 1]):
        if not (key := _KEY.fullmatch(line)):
            continue
        block = list(_below(lines, start, len(key["indent"])))
        if not block or block[-1][0] < near:
            continue
        column = min(indent for _, indent in block)
        items = [k for k, indent in block if indent == column]
        bare = [k for k in items if not lines[k].lstrip().startswith("-")]
        if bare and len(bare) < len(items) and not _goes_on(lines[start + 1 : bare[0]]):
            return (
                bare[0], column, "“- ” is missing in front of this line of a list",
                f"write - {lines[bare[0]].strip()[:40]}",
            )  # fmt: skip
    return None


def _below(lines: Sequence[str], start: int, indent: int) -> Iterator[tuple[int, int]]:
    """The lines that belong to the key in line `start`, each with the column where it begins."""
    for k in range(start + 1, len(lines)):
        text = lines[k].lstrip(" ")
        if not text or text.startswith("#"):
            continue
        column = len(lines[k]) - len(text)
        if column <= indent:
            return
        yield k, column


def _goes_on(before: Sequence[str]) -> bool:
    """Whether a bracket or a quote of these lines is still open: what follows belongs to it."""
    text = "\n".join(before)
    opened = sum(text.count(sign) for sign in _OPEN) - sum(text.count(sign) for sign in _CLOSED)
    return opened != 0 or text.count('"') % 2 == 1
