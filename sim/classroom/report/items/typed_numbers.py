"""Wrong numbers that a class typed: those that the author knows, and the others that came often."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from sim.classroom.files.keyed import KeyedItem
from sim.classroom.report.items.foreseen import Foreseen
from sim.classroom.report.marked import Answer
from sim.lesson.kinds.number import Number, Wrong, known_wrong
from sim.scene.said import listed, said

OFTEN = 2
"""Students who typed the same number, before it is told."""

MOST = 3
"""Other numbers that are told of a question."""


def typed_wrong(answer: Answer, question: Number) -> Wrong | None:
    """The known wrong number that was typed: the one that marking takes it for."""
    k = known_wrong(answer.value, question.wrong) if is_wrong_number(answer) else None
    return None if k is None else question.wrong[k]


def is_wrong_number(answer: Answer) -> bool:
    """Whether a number was typed, and the wrong one."""
    number = isinstance(answer.value, (int, float)) and not isinstance(answer.value, bool)
    return number and answer.mark is not None and answer.mark.verdict == "wrong"


def shown_wrong(wrong: Wrong, question: Number) -> str:
    """A known wrong number as people read it."""
    return _shown(wrong.value, question)


def told_numbers(answers: Sequence[Answer], question: Number) -> list[Foreseen]:
    """Each wrong number that the author knows, and who typed it."""
    return [
        Foreseen(
            shown := shown_wrong(wrong, question),
            shown,
            [a for a in answers if typed_wrong(a, question) is wrong],
            wrong.belief,
        )
        for wrong in question.wrong
    ]


def other_numbers(
    answers: Sequence[Answer], keyed: KeyedItem | None
) -> list[dict[str, Any]] | None:
    """The wrong numbers that came often and that the author does not know; None of other items."""
    question = keyed.question if keyed else None
    if not isinstance(question, Number):
        return None
    typed = Counter(
        float(a.value) for a in answers if is_wrong_number(a) and typed_wrong(a, question) is None
    )
    often = [(value, count) for value, count in typed.most_common(MOST) if count >= OFTEN]
    return [{"label": _shown(value, question), "count": count} for value, count in often]


def typed_sentence(row: Mapping[str, Any]) -> str:
    """These numbers in words; empty where there are none."""
    if not row["typed"]:
        return ""
    told = [said("{number} ({n} times)", number=one["label"], n=f"{one['count']}")
            for one in row["typed"]]  # fmt: skip
    return said("Other wrong numbers: {numbers}.", numbers=listed(told))


def _shown(value: float, question: Number) -> str:
    return f"{value:g} {question.unit}".strip()
