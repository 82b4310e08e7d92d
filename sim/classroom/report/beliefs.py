"""What students often think, and the texts that a person reads."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

from sim.classroom.files.keyed import KeyedForm, KeyedItem
from sim.classroom.handouts.answered import answer_words
from sim.classroom.report.marked import Answer, Marked
from sim.classroom.report.numerals import students as of_students
from sim.lesson.mark import is_empty
from sim.scene.said import joined, said

OFTEN = 2
"""Items in which a student chose answers of one belief, before it is named."""


def belief_rows(files: Sequence[Marked], form: KeyedForm | None) -> list[dict[str, Any]]:
    """Beliefs that a student chose in two items or more, and how many students did."""
    if not form:
        return []
    says = {tag: text for item in form.items.values() for tag, text in item.beliefs.items()}
    often: Counter[str] = Counter()
    sure: Counter[str] = Counter()
    asked = any(item.question.common.sure for item in form.items.values())
    for file in files:
        chosen: Counter[str] = Counter()
        surely: Counter[str] = Counter()
        for answer in file.answers.values():
            for tag in set(answer.mark.beliefs if answer.mark else ()):
                chosen[tag] += 1
                surely[tag] += answer.sure == "sure"
        often.update(tag for tag, count in chosen.items() if count >= OFTEN)
        sure.update(tag for tag, count in surely.items() if count >= OFTEN)
    return [
        belief_row(tag, says[tag], count, sure[tag] if asked else None)
        for tag, count in sorted(often.items(), key=lambda one: (-one[1], one[0]))
    ]


def belief_row(tag: str, says: str, students: int, sure: int | None) -> dict[str, Any]:
    """A belief with how many hold it; `sure` None: nobody was asked."""
    text: str = said("{students} chose answers in two items or more that go with: “{belief}”",
                students=of_students(students), belief=says)  # fmt: skip
    if sure is not None:
        text = joined(text, said("{n} of them were sure of two or more.", n=f"{sure}"))
    return {"belief": tag, "says": says, "students": students, "sure": sure, "sentence": text}


def word_rows(files: Sequence[Marked], form: KeyedForm | None) -> list[dict[str, Any]]:
    """Answers that a person reads, question by question, with the marks given so far: those in
    words, and a number read off a run that its file does not tell."""
    if not form:
        return []
    rows = []
    for name, keyed in form.items.items():
        answers = [
            {
                "student": f.who,
                "text": answer_words(keyed, f.answers[name].value),
                "marks": f.answers[name].mark.marks,  # type: ignore[union-attr]
            }
            for f in files
            if name in f.answers and _is_read(keyed, f.answers[name])
        ]
        if answers or keyed.question.free:
            rows.append({"id": name, "ask": keyed.ask, "worth": keyed.worth,
                         "rubric": dict(keyed.rubric), "answers": answers})  # fmt: skip
    return rows


def _is_read(keyed: KeyedItem, answer: Answer) -> bool:
    if keyed.question.free:
        return isinstance(answer.value, str) and not is_empty(answer.value)
    if answer.item is None or answer.foreign or not answer.worth:
        return False
    return keyed.mark(answer.value, answer.item.own).verdict == "open"
