"""What is known of the answers to `short`: the accepted ones and the wrong ones often given."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from sim.lesson import keys
from sim.lesson.beliefs import BELIEFS
from sim.lesson.keys import PROSE, PROSES, Key
from sim.lesson.kinds.options import read_belief
from sim.lesson.kinds.plain_words import plain
from sim.scene.problem import Path, Problem

WRONG_KEYS = (
    Key("text", "a wrong answer that is often given", "A pushes harder", PROSES, True),
    Key("belief", "tag of the belief behind it", "mover-pushes-more", {"enum": sorted(BELIEFS)}),
    Key("feedback", "shown to who gave it", "Look at both arrows.", PROSE),
)
AS_WRITTEN = "as_written"
"""Says in a row of a key file that its texts are as the author wrote them, points and all."""

_HINT = "accept: [zero, 0 N]"
_COMMA = re.compile(r"[,，、](?![0-9])|(?<![0-9])[,，、]")  # not that of 0,5 N
_LOST_POINT = re.compile(r"(?<=[0-9]) (?=[0-9])")

KnownWrong = tuple[tuple[str, ...], str, str]
"""Texts, belief, feedback."""


def read_accept(table: Mapping[str, Any], path: Path, problems: list[Problem]) -> tuple[str, ...]:
    """The accepted texts as written; each must say something when it is compared."""
    accept = keys.texts(table, "accept", path, problems, _HINT)
    here = (*path, "accept")
    if isinstance(table.get("accept"), str) and _COMMA.search(table["accept"]):
        parts = ", ".join(part.strip() for part in _COMMA.split(accept[0]) if part.strip())
        message = "this is one answer, commas and all: several stand in brackets"
        hint = f'several: accept: [{parts}]; one: accept: ["{accept[0]}"]'
        problems.append(Problem(here, "not-a-list", message, hint))
    _say_something(table.get("accept"), here, problems)
    return accept


def read_wrong(
    table: Mapping[str, Any], path: Path, problems: list[Problem]
) -> tuple[KnownWrong, ...]:
    """The wrong answers that are known, with the belief behind each and what is said to it."""
    hint = "wrong:\n    - {text: A pushes harder, belief: mover-pushes-more}"
    found = []
    for here, row in keys.tables(table, "wrong", WRONG_KEYS, path, problems, hint):
        texts = keys.texts(row, "text", here, problems, hint)
        _say_something(row.get("text"), (*here, "text"), problems)
        given = keys.text(row, "feedback", here, problems) or ""
        found.append((texts, read_belief(row, here, problems), given))
    return tuple(found)


def _say_something(given: object, path: Path, problems: list[Problem]) -> None:
    """One text or a list: none may be nothing but what does not count."""
    listed = given if isinstance(given, (list, tuple)) else [given]
    for k, text in enumerate(listed):
        if isinstance(text, str) and text.strip() and not plain(text):
            message = f"“{text[:40]}” is nothing but punctuation, which does not count"
            here = path if listed is not given else (*path, k)
            problems.append(Problem(here, "not-text", message, "write words, numbers or signs"))


def of_key(texts: Iterable[str], *, as_written: bool) -> tuple[str, ...]:
    """The texts of a key file. Older ones hold them without points: 1 5 n was 1.5 N there."""
    written = tuple(texts)
    older = (text for text in written if _LOST_POINT.search(text) and not as_written)
    return (*written, *(_LOST_POINT.sub(".", text) for text in older))
