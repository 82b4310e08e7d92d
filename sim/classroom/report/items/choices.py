"""What was answered of what an author foresaw: options, known wrong numbers, known wrong lines."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

from sim.classroom.files.keyed import KeyedItem
from sim.classroom.report.items.drawn_links import told_links
from sim.classroom.report.items.foreseen import Foreseen
from sim.classroom.report.items.typed_numbers import told_numbers
from sim.classroom.report.marked import Answer
from sim.lesson.kinds.interactions import Interactions
from sim.lesson.kinds.number import Number


def choices_of(answers: Sequence[Answer], keyed: KeyedItem | None) -> list[dict[str, Any]]:
    """One row for each, with how many gave it and what students who give it often think."""
    if keyed is None:
        return _letters(answers)
    return [
        {
            "option": told.option,
            "label": told.label,
            "text": told.text,
            "correct": told.correct,
            "count": len(told.gave),
            "sure": sum(a.sure == "sure" for a in told.gave),
            "belief": told.belief,
            "says": keyed.beliefs.get(told.belief, ""),
        }
        for told in _foreseen(answers, keyed)
    ]


def chose_option(answer: Answer, option: str) -> bool:
    """Whether this option was chosen, alone or with others."""
    value = answer.value
    return bool(value == option or (isinstance(value, (list, tuple)) and option in value))


def letter(option: str) -> str:
    """An option as students see it: a letter."""
    return option.upper() if len(option) == 1 else option


def _letters(answers: Sequence[Answer]) -> list[dict[str, Any]]:
    """Without a key: only how often each letter was chosen."""
    counts = Counter(a.value for a in answers if a.type == "single" and isinstance(a.value, str))
    return [
        {"option": o, "label": letter(o), "text": "", "count": counts[o]} for o in sorted(counts)
    ]


def _foreseen(answers: Sequence[Answer], keyed: KeyedItem) -> list[Foreseen]:
    if isinstance(keyed.question, Number):
        return told_numbers(answers, keyed.question)
    if isinstance(keyed.question, Interactions):
        return told_links(answers, keyed.question)
    if keyed.question.KIND not in ("single", "multiple", "idea"):
        return []
    key = keyed.question.key()
    return [
        Foreseen(
            option,
            letter(option),
            [a for a in answers if chose_option(a, option)],
            key["beliefs"].get(option, ""),
            text=keyed.texts.get(f"option-{option}", ""),
            correct=option in key["correct"],
        )
        for option in keyed.question.asked()["options"]
    ]
