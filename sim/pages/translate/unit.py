"""One text of a lesson that readers read: where it stands, and what must stay in it.

A translation may say everything otherwise, but keeps the marks: formulas, code, the targets of
links, attribute lists, names in braces. They are compared as collections, since they may move.
"""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass
from typing import Literal

from sim.scene.quantity import unit_of

Form = Literal["markdown", "yaml"]

_FORMULA = r"\\\(.+?\\\)|\\\[.+?\\\]|(?<!\\)\$\$.+?(?<!\\)\$\$|(?<!\\)\$.+?(?<!\\)\$"
_CODE = r"(?P<ticks>`+)(?!`).+?(?<!`)(?P=ticks)(?!`)"
_LIST = r"\{:[^}\n]*\}|(?<=\))\{[^}\n]*\}"
_TARGET = r"\]\([^)\s]+(?=[)\s])|\]\[[^\]\n]*\]|\[\^[^\]\n]+\]"
_PLACE = r"(?<![\\{^_])\{\w+\}"
_TAG = r"</?[a-zA-Z][^>\n]*>"
MARKS = re.compile("|".join((_FORMULA, _CODE, _LIST, _TARGET, _TAG, _PLACE)), re.DOTALL)
_LETTERS = re.compile(r"[^\W\d_]")


@dataclass(frozen=True, slots=True)
class Unit:
    """Characters `start` to `end` of a file, and the `text` in them as a translator sees it.

    `form`: how a translation is put back. `where`: what it is, for the translator. `indent`: what
    stands in front of the second line of a Markdown text. `item`: the id of the question.
    """

    start: int
    end: int
    text: str
    form: Form
    where: str
    indent: str = ""
    item: str = ""


def is_prose(text: str) -> bool:
    """Whether there is something to translate: more than a number, a formula or a letter."""
    if text.strip()[:1].isdigit() and unit_of(text) and " " in text.strip():
        return len(text.split()) > 2
    left = MARKS.sub(" ", text)
    return len(_LETTERS.findall(left)) > 1


def marks(text: str) -> Counter[str]:
    """Everything in a text that its translation has too, each as often."""
    return Counter(" ".join(found[0].split()) for found in MARKS.finditer(text))


def changed_marks(text: str, said: str) -> tuple[list[str], list[str]]:
    """The marks of `text` that `said` lacks, and those that only `said` has."""
    here, there = marks(text), marks(said)
    return sorted((here - there).elements()), sorted((there - here).elements())
