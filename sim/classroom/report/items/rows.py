"""What a class answered, item by item."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

from sim.classroom.files.keyed import KeyedForm, KeyedItem
from sim.classroom.refusal import FEW
from sim.classroom.report.items.choices import choices_of
from sim.classroom.report.items.second_thoughts import changed_of, tries_of
from sim.classroom.report.items.statistics import NO_NUMBERS, add_numbers
from sim.classroom.report.items.typed_numbers import other_numbers
from sim.classroom.report.marked import Answer, Marked
from sim.classroom.report.numerals import signed
from sim.classroom.statistics.item_numbers import item_marks, levels_of
from sim.lesson.answer_file import NO_QUESTIONS
from sim.lesson.mark import is_empty
from sim.scene.said import counted, joined, said


def item_rows(
    files: Sequence[Marked], form: KeyedForm | None, counted: Sequence[str]
) -> list[dict[str, Any]]:
    """One row for each item of the form; without a key for each that somebody answered."""
    names = (
        list(form.items)
        if form
        else sorted({a.id for f in files for a in f.answers.values() if a.type not in NO_QUESTIONS})
    )
    totals = [float(f.total(counted)) for f in files]
    return [
        _row(
            k, name, files, form.items[name] if form else None, totals if name in counted else None
        )
        for k, name in enumerate(names, 1)
    ]


def question_label(number: int) -> str:
    """A question as students know it, from 1."""
    return said("Question {number}", number=str(number))


def _row(
    number: int,
    name: str,
    files: Sequence[Marked],
    keyed: KeyedItem | None,
    totals: list[float] | None,
) -> dict[str, Any]:
    mine = [k for k, f in enumerate(files) if name in f.answers and not f.answers[name].foreign]
    answers = [files[k].answers[name] for k in mine]
    verdicts = Counter(a.mark.verdict for a in answers if a.mark)
    row: dict[str, Any] = {
        "id": name,
        "label": question_label(number) if keyed else name,
        "ask": keyed.ask if keyed else "",
        "type": keyed.question.KIND if keyed else (answers[0].type if answers else ""),
        "worth": keyed.worth if keyed else 0,
        **({"optional": True} if keyed and keyed.optional else {}),
        "n": len(answers),
        "answered": sum(not is_empty(a.value) for a in answers),
        "sure": _sure(answers, keyed),
        "tries": tries_of(answers),
        "changed": changed_of(answers, keyed),
        "right": verdicts["right"],
        "partly": verdicts["partly"],
        "wrong": verdicts["wrong"] + verdicts["unclear"],
        "unread": verdicts["open"] if keyed and keyed.question.MARKED else 0,
        "empty": verdicts["empty"] if keyed else len(files) - len(answers),
        "choices": choices_of(answers, keyed),
        "difficulty": None,
        "discrimination": None,
        "point_biserial": None,
        **NO_NUMBERS,
        "typed": other_numbers(answers, keyed),
        "notes": [],
    }
    if keyed and totals is not None and row["worth"]:
        # What is compared with a total is of those who have one: a part of it would pull it down.
        with_total = [
            (files[k].answers[name].marks, totals[k]) for k in mine if not files[k].foreign
        ]
        marks, whole = [m for m, _ in with_total], [t for _, t in with_total]
        everybody = len(answers), sum(a.marks for a in answers)
        add_numbers(row, item_marks(marks, whole), levels_of(marks, whole), row["worth"], everybody)
    row["sentence"] = item_sentence(row)
    return row


def _sure(answers: Sequence[Answer], keyed: KeyedItem | None) -> dict[str, int] | None:
    """How many said that they were sure, of those who were right and of those who were wrong."""
    if not keyed or not keyed.question.common.sure:
        return None
    found = Counter(
        a.mark.verdict for a in answers if a.sure == "sure" and a.mark and not is_empty(a.value)
    )
    return {"right": found["right"], "wrong": found["wrong"] + found["partly"] + found["unclear"]}


def item_sentence(row: dict[str, Any]) -> str:
    """An item in words: how many answered it right, and the wrong answer chosen most."""
    if not row["worth"] or not row["n"]:
        return ""
    if row["unread"]:
        left = f"{row['empty']}"
        return counted("1 answer to be read by you, {open} left it open.",
                       "{n} answers to be read by you, {open} left it open.",
                       n=row["unread"], open=left)  # fmt: skip
    return joined(_right(row), _certain(row), _chosen(row), _rough(row))


def _right(row: dict[str, Any]) -> str:
    values = {"right": f"{row['right']}", "n": f"{row['n']}"}
    if row["n"] >= FEW:
        percent = f"{100 * row['right'] / row['n']:.0f}"
        text = said("{right} of {n} answered it right ({percent} %)", percent=percent, **values)
    else:
        text = said("{right} of {n} answered it right", **values)
    if row["empty"]:
        return said("{sentence}, {open} left it open.", sentence=text, open=f"{row['empty']}")
    return said("{sentence}.", sentence=text)


def _certain(row: dict[str, Any]) -> str:
    sure = row["sure"]
    if not sure or not any(sure.values()):
        return ""
    return said("Sure and right: {right}; sure and wrong: {wrong}.", right=f"{sure['right']}",
                wrong=f"{sure['wrong']}")  # fmt: skip


def _chosen(row: dict[str, Any]) -> str:
    """The wrong answer that was chosen most, and what is often thought with it."""
    wrong = [c for c in row["choices"] if not c.get("correct") and c["count"] > 1]
    if not wrong:
        return ""
    most = max(wrong, key=lambda c: c["count"])
    values = {"count": f"{most['count']}", "answer": most["label"]}
    if says := most.get("says"):
        return said("{count} chose {answer}; students who choose it often think: “{belief}”",
                    belief=says, **values)  # fmt: skip
    return said("{count} chose {answer}.", **values)


def _rough(row: dict[str, Any]) -> str:
    if row["discrimination"] is None:
        return ""
    return said("Rough: upper minus lower part of the class {difference}.",
                difference=signed(row["discrimination"]))  # fmt: skip
