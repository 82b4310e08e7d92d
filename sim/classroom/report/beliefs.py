"""What students often think, and the texts that a person reads."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

from sim.classroom.files.keyed import KeyedForm
from sim.classroom.report.marked import Marked
from sim.classroom.report.sentences import many
from sim.lesson.mark import is_empty

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
    rows = []
    for tag, count in often.most_common():
        students = many(count, "student")
        text = f"{students} chose answers in two items or more that go with: “{says[tag]}”"
        if asked:
            text += f" {sure[tag]} of them were sure of two or more."
        rows.append({"belief": tag, "says": says[tag], "students": count,
                     "sure": sure[tag] if asked else None, "sentence": text})  # fmt: skip
    return rows


def word_rows(files: Sequence[Marked], form: KeyedForm | None) -> list[dict[str, Any]]:
    """Questions that a person reads: every answer of the class, with the marks given so far."""
    if not form:
        return []
    rows = []
    for name, keyed in form.items.items():
        question = keyed.question
        if question.KIND != "long" and not (
            question.KIND == "short" and not question.key()["accept"]
        ):
            continue
        answers = [
            {
                "student": f.who,
                "text": f.answers[name].value,
                "marks": f.answers[name].mark.marks,  # type: ignore[union-attr]
            }
            for f in files
            if isinstance(f.answers[name].value, str) and not is_empty(f.answers[name].value)
        ]
        rows.append({"id": name, "ask": keyed.ask, "worth": keyed.worth,
                     "rubric": dict(keyed.rubric), "answers": answers})  # fmt: skip
    return rows
