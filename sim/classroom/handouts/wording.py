"""Words that the slips and the sheet of a class share, and how they are told in a language."""

from __future__ import annotations

from sim.classroom.report.sentences import begins
from sim.classroom.show.prose import prose
from sim.scene.said import template

FORMS = {
    "pre": template("Before the lesson"),
    "worksheet": template("Worksheet"),
    "post": template("After the lesson"),
    "delayed": template("Some time later"),
}
LONGEST = 220
"""Characters of a question that are printed: as many as it takes to know it again."""


def cut(words: str, most: int = LONGEST) -> str:
    """The beginning of an author's or a student's text, up to the end of a word."""
    return begins(prose(words), most)
