"""Words that the slips and the sheet of a class share, and how they are told in a language."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from sim.classroom.show.html_parts import text
from sim.classroom.show.prose import prose
from sim.scene.said import in_words, template

Tell = Callable[[str], str]
"""A sentence of ours as HTML text, in the language of the paper."""

FORMS = {
    "pre": template("Before the lesson"),
    "worksheet": template("Worksheet"),
    "post": template("After the lesson"),
    "delayed": template("Some time later"),
}
LONGEST = 220
"""Characters of a question that are printed: as many as it takes to know it again."""


def telling(words: Mapping[str, str]) -> Tell:
    """`words`: what each English sentence is in the language; empty for English."""
    return lambda sentence: text(in_words(sentence, words))


def cut(words: str, most: int = LONGEST) -> str:
    """The beginning of an author's or a student's text, up to the end of a word."""
    plain = prose(words)
    return plain if len(plain) <= most else f"{plain[:most].rsplit(' ', 1)[0]} …"


def numbers(found: Iterable[int]) -> str:
    """1, 2, 5."""
    return ", ".join(map(str, found))
