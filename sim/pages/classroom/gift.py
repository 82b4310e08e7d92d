"""GIFT: Moodle's short text format, which other platforms read too."""

from __future__ import annotations

import re
from collections.abc import Iterable

from sim.pages.classroom.moodle import literal, plain_text
from sim.pages.classroom.portable import Portable

_SPECIAL = re.compile(r"([~=#{}:\\])")


def gift(title: str, questions: Iterable[Portable]) -> str:
    """The file; `title` names the category."""
    head = f"$CATEGORY: $course$/top/{title.replace('/', '//')}"
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
        weight = "" if percent == 100 else f"%{percent:.0f}%"
        return f"\n={weight}{literal(_text(text))}{said}"
    return f"\n{'=' if percent == 100 else '~'}{_text(text)}{said}"


def _text(html: str) -> str:
    """HTML, marked; an arrow stands in it in HTML's way, for a bare one divides pairs."""
    return _marked(html).replace("->", "-&gt;")


def _marked(text: str) -> str:
    """The text with what GIFT takes for its own marked; a line end would end a comment."""
    return _SPECIAL.sub(r"\\\1", text).replace("\n", "\\n")
