"""What is for the teacher alone stays out of the site: rubrics and notes in a lesson's text.

A site goes to students as it is. The text that a page carries has a few words in the place of each
such value; a teacher's own file puts them back, character by character.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from sim.pages.findings import Finding
from sim.pages.teach.pieces import Lines, blocks
from sim.pages.teach.spans import Value, values
from sim.pages.text.fence_scan import Block

WORDS = "(stands in the teacher's own file)"
PLACE = f'"{WORDS}"'
KEYS = ("rubric", "note")

Name = tuple[str | int, ...]  # the block's id, then the path of the value


def withhold(text: str) -> str:
    """The text with PLACE for every value that is for the teacher alone."""
    for value in reversed([value for _, value in _hidden(text)]):
        text = text[: value.start] + PLACE + text[value.end :]
    return text


def restore(text: str, own: str) -> tuple[str, int]:
    """The text with the values of the teacher's `own` file put back, and how many are missing.

    A value is found by the id of its block. What does not stand in `own` stays as it is.
    """
    kept = {name: own[value.start : value.end] for name, value in _hidden(own)}
    missing = 0
    for name, value in reversed(list(_hidden(text))):
        if value.value != WORDS:
            continue
        if name in kept:
            text = text[: value.start] + kept[name] + text[value.end :]
        else:
            missing += 1
    return text, missing


KEPT_OUT = "what only teachers read was kept out of the site"


def withheld_findings(text: str, file: str) -> list[Finding]:
    """A lesson saved without the teacher's own texts must not replace one that has them: told once,
    where the first is missing, for all have one remedy."""
    places = [
        (k, at.start() + 1)
        for k, line in enumerate(Lines.of(text).lines, 1)
        for at in re.finditer(re.escape(WORDS), line)
    ]
    if not places:
        return []
    hint = "in teacher mode add your own file of the lesson before you save, or write the text here"
    message = f"a text for teachers is missing here: {KEPT_OUT}"
    if more := len(places) - 1:
        others = f"{more} more place{'s' * (more > 1)}"
        message = f"texts for teachers are missing, here and in {others}: {KEPT_OUT}"
    return [Finding(file, *places[0], "withheld", message, hint)]


def _hidden(text: str) -> Iterator[tuple[Name, Value]]:
    for block in blocks(text):
        if block.name == "question":
            identity = _identity(text, block)
            for value in values(text, block):
                if value.path and value.path[0] in KEYS:  # a block of bare words has no path
                    yield (identity, *value.path), value


def _identity(text: str, block: Block) -> str:
    found = (value.value for value in values(text, block) if value.path == ("id",))
    return next(found, "")
