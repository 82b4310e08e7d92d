"""What one student is told about the answers to one form: values, no words of ours.

A slip names what is right by number and speaks about few questions only: those that the student was
sure of and wrong about first, for a belief is more worth a talk than a gap.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sim.classroom.files.keyed import KeyedForm, KeyedItem
from sim.classroom.handouts.answered import answer_words, right_words
from sim.classroom.report.flags.sorted_out import ORDER
from sim.classroom.report.marked import Answer, Keys, Marked, lesson_title
from sim.classroom.report.numerals import in_order

MOST_TOLD = 4
"""Questions that a slip speaks about; what is more is named by number."""

FEWEST_TOLD = 2
"""Of each form, where before and after share a slip: it would be higher than half a page."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Look:
    """A question to be looked at again. `hints`: the author's feedback on this answer."""

    number: int
    ask: str
    answer: str
    sure: bool
    hints: tuple[str, ...]
    right: str
    explain: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Given:
    """An answer in words with the marks that a person gave, and the first idea beside it."""

    number: int
    ask: str
    answer: str
    idea: str
    marks: int | None
    of: int


@dataclass(frozen=True, slots=True, kw_only=True)
class FormSlip:
    """One form of one student. Numbers are those that students know, from 1.

    `marks` of `of` so far; None without a key. `sure`: how many answers the student was sure of,
    and how many of these are right; None where not asked. `foreign`: answered in another wording
    than the key's, not marked; then there is no total. `unanswered`: nothing was answered at all.
    """

    form: str
    saved: str
    marks: int | None
    of: int
    right: tuple[int, ...] = ()
    look: tuple[Look, ...] = ()
    also: tuple[int, ...] = ()
    open: tuple[int, ...] = ()
    waiting: tuple[int, ...] = ()
    given: tuple[Given, ...] = ()
    sure: tuple[int, int] | None = None
    foreign: tuple[int, ...] = ()
    unanswered: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Slip:
    """All forms of one student in one lesson. Without a code word `student` is empty."""

    student: str
    file: str
    group: str
    lesson: str
    title: str
    forms: tuple[FormSlip, ...]


def slips(counted: Sequence[Marked], keys: Keys, groups: Sequence[str]) -> list[Slip]:
    """A slip for each student and lesson, by group and name; those without a code word last."""
    found: dict[tuple[str, str, str], list[Marked]] = {}
    for file in counted:
        found.setdefault((file.file.site, file.file.lesson, file.student), []).append(file)
    made = [
        Slip(
            student=files[0].file.student.strip(),
            file=files[0].name,
            group=files[0].group,
            lesson=files[0].file.lesson,
            title=lesson_title(files[0].file.lesson, (keys.of(one.file) for one in files)),
            forms=tuple(
                form_slip(file, keys.of(file.file), max(MOST_TOLD // len(files), FEWEST_TOLD))
                for file in sorted(files, key=lambda one: ORDER.index(one.file.form))
            ),
        )
        for files in found.values()
    ]
    return sorted(
        made,
        key=lambda s: (groups.index(s.group), not s.student, in_order(s.student), s.file, s.lesson),
    )


def form_slip(file: Marked, key: KeyedForm | None, most: int) -> FormSlip:
    """What is said about one file, and about at most so many of its questions."""
    if key is None:
        return FormSlip(form=file.file.form, saved=file.file.saved, marks=None, of=0)
    marked = [(k, key.items[name], file.answers[name]) for k, name in enumerate(key.items, 1)]
    worth = [(k, item, a) for k, item, a in marked if a.mark and a.mark.of and not a.foreign
             and not (a.optional and _verdict(a) == "empty")]  # fmt: skip
    wrong = [(k, item, a) for k, item, a in worth if _verdict(a) == "unclear"
             or (_verdict(a) in ("wrong", "partly") and not item.question.free)]  # fmt: skip
    wrong.sort(key=lambda one: (one[2].sure != "sure", one[0]))
    answered = [(item, a) for _, item, a in worth if _verdict(a) not in ("empty", "open")]
    sure = [a for item, a in answered if item.question.common.sure and a.sure == "sure"]
    return FormSlip(
        form=file.file.form,
        saved=file.file.saved,
        marks=sum(a.marks for _, _, a in worth),
        of=sum(a.worth for _, _, a in worth),
        right=tuple(k for k, _, a in worth if _verdict(a) == "right"),
        look=tuple(_look(*one) for one in wrong[:most]),
        also=tuple(sorted(k for k, _, _ in wrong[most:])),
        open=tuple(k for k, _, a in worth if _verdict(a) == "empty"),
        waiting=tuple(k for k, _, a in worth if _verdict(a) == "open"),
        given=tuple(_given(k, item, a, key.items, file.answers) for k, item, a in worth
                    if _tells(item, a)),
        sure=(len(sure), sum(_verdict(a) == "right" for a in sure)) if sure else None,
        foreign=file.foreign_numbers,
        unanswered=file.unanswered,
    )  # fmt: skip


def _verdict(answer: Answer) -> str:
    return answer.mark.verdict if answer.mark else "empty"


def _tells(item: KeyedItem, answer: Answer) -> bool:
    """Whether an answer in words is worth a line: it was marked, or a first idea stands beside."""
    marked = answer.mark is not None and answer.mark.marks is not None
    said = bool(answer_words(item, answer.value)) and item.question.free
    return said and (marked or bool(item.question.common.idea))


def _look(number: int, item: KeyedItem, answer: Answer) -> Look:
    texts = item.question.feedback()
    shown = answer.mark.shown if answer.mark else ()
    return Look(
        number=number,
        ask=item.ask,
        answer=answer_words(item, answer.value),
        sure=answer.sure == "sure",
        hints=tuple(texts[name] for name in shown if name in texts),
        right=right_words(item, answer.item.own if answer.item else None),
        explain=item.question.common.explain,
    )


def _given(
    number: int,
    item: KeyedItem,
    answer: Answer,
    items: Mapping[str, KeyedItem],
    answers: Mapping[str, Answer],
) -> Given:
    name = item.question.common.idea
    first = answer_words(items[name], answers[name].value) if name in items else ""
    return Given(
        number=number, ask=item.ask, answer=answer_words(item, answer.value), idea=first,
        marks=answer.mark.marks if answer.mark else None, of=answer.mark.of if answer.mark else 0,
    )  # fmt: skip
