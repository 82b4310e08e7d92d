"""Answers that are pictures: who hears them, a slip and the report of a class have the words beside
a picture and nothing else, so answers to choose from must differ in these."""

from __future__ import annotations

import re
from collections.abc import Sequence

from sim.scene.problem import Path, Problem

_PICTURE = re.compile(r"!\[([^\]]*)\]\([^)]*\)")
_TWICE = "a student cannot tell the two apart: say in each what is different"
_HINT = "say in each what is different, without saying which is right: ![A longer than B](a.png)"


def alike(texts: Sequence[str], places: Sequence[Path], problems: list[Problem]) -> None:
    """A problem at the first text that stands there already, or has only another picture."""
    heard: dict[str, str] = {}
    for text, place in zip(texts, places, strict=True):
        words = " ".join(_PICTURE.sub(r"\1", text).split())
        if not words:  # told where it is read
            continue
        if words in heard and " ".join(heard[words].split()) == " ".join(text.split()):
            message = f"“{words[:40]}” stands there twice"
            problems.append(Problem(place, "twice", message, _TWICE))
            return
        if heard.setdefault(words, text) != text and "![" in text + heard[words]:
            message = "two pictures to choose from have the same words beside them"
            problems.append(Problem(place, "alike", message, _HINT))
            return


def places(path: Path, listed: Sequence[object]) -> list[Path]:
    """Where each of a list stands."""
    return [(*path, k) for k in range(len(listed))]
