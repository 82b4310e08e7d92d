"""GIFT: Moodle's short text format, which other platforms read too."""

from __future__ import annotations

import re
from collections.abc import Iterable

from sim.pages.classroom.moodle_text import category, literal, plain_text
from sim.pages.classroom.portable import Portable

_SPECIAL = re.compile(r"([~=#{}:\\])")
_FORMAT = re.compile(r"\[(?=(?:html|plain|moodle|markdown)\])")  # at a beginning, it is taken away


def gift(title: str, questions: Iterable[Portable]) -> str:
    """The file; `title` names the category."""
    head = f"$CATEGORY: {category(title)}"
    return "\n\n".join([head, *map(_question, questions)]) + "\n"


def _question(q: Portable) -> str:
    body = _body(q)
    explain = f"\n####{_text(q.explain)}" if q.explain else ""
    tags = " ".join(f"[tag:{topic}]" for topic in q.topics)
    note = f"// {tags} [id:{q.id}]\n" if tags else f"// [id:{q.id}]\n"
    return f"{note}::{_text(q.id)}::[html]{_text(q.ask)}{{{body}{explain}\n}}"


def _body(q: Portable) -> str:
    if q.shape == "number":
        value, tolerance = q.number
        return f"#{value!r}:{tolerance!r}"
    if q.shape == "essay":
        return ""
    if q.shape == "pairs":
        pairs = [*q.pairs, *(("", other) for other in q.others)]
        return "".join(f"\n={_text(left)} -> {_marked(plain_text(right))}" for left, right in pairs)
    return "".join(_answer(q, *answer) for answer in q.answers)


def _answer(q: Portable, text: str, percent: float, feedback: str) -> str:
    said = f"#{_text(feedback)}" if feedback else ""
    if q.shape == "choices":
        weight = f"{percent:.5f}".rstrip("0").rstrip(".")
        return f"\n~%{weight}%{_text(text)}{said}"
    if q.shape == "short":
        as_typed = "[plain]" if _FORMAT.match(text) else ""
        return f"\n={_weight(percent, 100, text)}{as_typed}{literal(_marked(text))}{said}"
    # Of a right choice Moodle reads no weight: it would stand in the text.
    return f"\n{'=' if percent == 100 else '~' + _weight(percent, 0, text)}{_text(text)}{said}"


def _weight(percent: float, usual: float, text: str) -> str:
    """A share of the marks, where it is not the usual one or the text could be taken for one."""
    return f"%{percent:.0f}%" if percent != usual or text.startswith("%") else ""


def _text(html: str) -> str:
    """HTML, marked; what GIFT reads in its own way stands in it in HTML's: an arrow divides pairs,
    a word in brackets names a format."""
    if _FORMAT.match(html):
        html = "&#91;" + html[1:]
    return _marked(html).replace("->", "-&gt;")


def _marked(text: str) -> str:
    """The text with what GIFT takes for its own marked; a line end would end a comment."""
    return _SPECIAL.sub(r"\\\1", text).replace("\n", "\\n")
