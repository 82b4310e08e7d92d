"""An answer, and the right one, in words that a student knows again."""

from __future__ import annotations

from sim.classroom.files.keyed import KeyedItem
from sim.lesson.kinds.arrange import Ordering
from sim.lesson.kinds.choice import Single
from sim.lesson.kinds.idea import Idea
from sim.lesson.kinds.number import Number
from sim.lesson.kinds.run import Reading
from sim.lesson.kinds.words import Short


def answer_words(keyed: KeyedItem, value: object) -> str:
    """What was answered; empty for kinds that are no text: tables, links, pairs."""
    question = keyed.question
    if isinstance(question, (Single, Idea)):
        chosen = value if isinstance(value, (list, tuple)) else [value]
        found = [keyed.texts.get(f"option-{name}", "") for name in chosen if isinstance(name, str)]
        words = "; ".join(text for text in found if text)
        return words or (value if isinstance(value, str) and not question.options else "")
    if isinstance(value, bool):
        return ""
    if isinstance(value, (int, float)) and isinstance(question, (Number, Reading)):
        return _number(value, question.unit)
    return value if isinstance(value, str) else ""


def right_words(keyed: KeyedItem, own: float | None = None) -> str:
    """The right answer; empty where a person judges, or where it takes more than a line.

    `own`: what the student's own run says, where it is known.
    """
    question = keyed.question
    if isinstance(question, Reading) and own is not None:
        return _number(own, question.unit)
    if isinstance(question, Single):
        right = [option.text for option in question.options if option.correct]
        return "; ".join(right)
    if isinstance(question, Number):
        return _number(question.answer, question.unit)
    if isinstance(question, Ordering):
        return " → ".join(question.order)
    if isinstance(question, Short):
        return question.accept[0] if question.accept else ""
    return ""


def _number(value: float, unit: str) -> str:
    sign = "−" if value < 0 else ""
    return f"{sign}{abs(value):g} {unit}".strip()
