"""Questions of a bank or a lesson in the few shapes that learning platforms have in common."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from html import escape
from types import MappingProxyType
from typing import Literal

from sim.lesson.kinds.arrange import Matching, Ordering
from sim.lesson.kinds.choice import Single
from sim.lesson.kinds.number import Number
from sim.lesson.kinds.words import Long, Short
from sim.lesson.question import Question
from sim.pages.language import tr
from sim.pages.question.inside import to_html, to_inline

NOWHERE: Mapping[str, str] = MappingProxyType({})
Shape = Literal["choice", "choices", "number", "short", "essay", "pairs"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Portable:
    """One question; texts are HTML. `answers`: text, percent of the marks, feedback.

    `order`: the lines of an ordering, which are `pairs` as well, for platforms without one.
    `sure`: the pages ask how sure a student is; no platform does. `scene`: the one that is watched
    before the question, in a lesson. `idea`: a first idea is shown beside it there.
    """

    id: str
    shape: Shape
    ask: str
    marks: int
    answers: tuple[tuple[str, float, str], ...] = ()
    number: tuple[float, float] = (0.0, 0.0)  # the answer and its tolerance
    wrong_numbers: tuple[tuple[float, float, str], ...] = ()  # with tolerance and feedback
    order: tuple[str, ...] = ()
    pairs: tuple[tuple[str, str], ...] = ()
    others: tuple[str, ...] = ()  # on the right, belonging to nothing
    rubric: Mapping[int, str] = field(default_factory=dict)
    explain: str = ""
    start: str = ""  # of a longer answer, to be gone on with
    topics: tuple[str, ...] = ()
    sure: bool = False
    scene: str = ""
    idea: bool = False
    words: bool = False  # there are words to use


def portable(
    questions: Iterable[Question], about: Mapping[str, str] = NOWHERE
) -> tuple[list[Portable], list[str]]:
    """The questions that can be taken along, and a sentence for each that cannot.

    `about`: ids of questions with the scene of their lesson that they are about.
    """
    taken, left = [], []
    for question in questions:
        made = _made(question, about.get(question.id, ""))
        if made is None:
            left.append(f"{question.id}: a question of type {question.KIND} stays here")
        else:
            taken.append(made)
    return taken, left


def _made(question: Question, scene: str) -> Portable | None:
    common = question.common
    ask, explain = to_html(common.ask), to_html(common.explain)

    def part(shape: Shape, **more: object) -> Portable:
        facts = {"id": question.id, "shape": shape, "ask": ask, "marks": common.marks,
                 "explain": explain, "topics": common.topics, "sure": common.sure,
                 "scene": scene, "idea": bool(common.idea),
                 "words": bool(getattr(question, "words", ())),
                 "start": getattr(question, "start", "")}  # fmt: skip
        return Portable(**{**facts, **more})  # type: ignore[arg-type]

    if isinstance(question, Single):
        several = question.KIND == "multiple"
        right = sum(option.correct for option in question.options)
        answers = tuple(
            (
                to_inline(option.text),
                100 / right if option.correct else (-100.0 if several else 0.0),
                to_inline(option.feedback),
            )
            for option in question.options
        )
        return part("choices" if several else "choice", answers=answers)
    if isinstance(question, Number):
        said = escape(tr("Answer in {unit}.", unit=question.unit))
        unit = f"<p>{said}</p>" if question.unit else ""
        wrong = tuple((w.value, w.tolerance, to_inline(w.feedback)) for w in question.wrong)
        return part("number", number=(question.answer, question.tolerance), wrong_numbers=wrong,
                    ask=f"{ask}{unit}")  # fmt: skip
    if isinstance(question, Short) and question.accept:
        known = tuple(
            (text, 0.0, to_inline(said)) for texts, _, said in question.wrong for text in texts
        )
        right_ones = tuple((text, 100.0, "") for text in question.accept)
        return part("short", answers=(*right_ones, *known), rubric=question.rubric,
                    marks=question.worth)  # fmt: skip
    if isinstance(question, Long):
        return part("essay", rubric=question.rubric, marks=question.worth)
    if isinstance(question, Ordering):
        lines = tuple(map(to_inline, question.order))
        pairs = tuple((f"{k}.", line) for k, line in enumerate(lines, start=1))
        return part("pairs", pairs=pairs, order=lines)
    if isinstance(question, Matching):
        count = len(question.left)
        joined = zip(question.left, question.right, strict=False)
        return part(
            "pairs",
            pairs=tuple((to_inline(left), to_inline(right)) for left, right in joined),
            others=tuple(map(to_inline, question.right[count:])),
        )
    return None
