"""What a question loses on its way to a learning platform, in sentences: nothing goes silently.

What holds for all of them stands in docs/teachers/platform.md: beliefs and hints stay here.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from html import unescape
from typing import Literal

from sim.pages.classroom.moodle_text import LONGEST, plain_text
from sim.pages.classroom.pictures import SHOWN, Pictures, no_pictures
from sim.pages.classroom.portable import Portable
from sim.pages.classroom.qti.mathml import FORMULA, Formulas, no_formulas, with_mathml

Target = Literal["moodle", "gift", "qti"]

MOST_RIGHT = 10
"""Right answers of one question whose share of the marks Moodle knows (100 % / n, n up to 10)."""

_OWN_LINK = re.compile(r'<a href="(?![a-z]+:)', re.IGNORECASE)


def losses(
    questions: Iterable[Portable],
    target: Target,
    pictures: Pictures = no_pictures,
    formulas: Formulas = no_formulas,
) -> list[str]:
    """A sentence for each loss, question by question; `pictures` and `formulas` that a file takes
    along."""
    return [
        f"{q.id}: {text}"
        for q in questions
        for text in (*_of(q, target), *_not_shown(q, target, pictures, formulas))
    ]


def fitting(questions: Iterable[Portable], target: Target) -> tuple[list[Portable], list[str]]:
    """The questions that the platform takes, and a sentence for each that it refuses."""
    fine, refused = [], []
    for q in questions:
        right = sum(percent > 0 for _, percent, _ in q.answers)
        lists = [plain_text(line) for line in (*(side for _, side in q.pairs), *q.others)]
        if q.shape == "choices" and target != "qti" and right > MOST_RIGHT:
            refused.append(f"{q.id}: {right} right answers; Moodle refuses more than {MOST_RIGHT}")
        elif q.shape == "pairs" and not all(map(str.strip, lists)):
            refused.append(f"{q.id}: a picture without words cannot be chosen from a list there")
        elif target != "qti" and any(len(line) > LONGEST for line in lists):
            refused.append(f"{q.id}: Moodle's lists hold {LONGEST} letters; a line has more")
        elif target == "gift" and q.shape == "short" and any("->" in a[0] for a in q.answers):
            refused.append(f"{q.id}: GIFT takes the arrow in a short answer for a pair")
        else:
            fine.append(q)
    return fine, refused


def _not_shown(
    q: Portable, target: Target, pictures: Pictures, formulas: Formulas
) -> Iterator[str]:
    texts = [q.ask, q.explain, *(t for a in q.answers for t in (a[0], a[2])),
             *(left for left, _ in q.pairs), *(said for _, _, said in q.wrong_numbers)]  # fmt: skip
    lines = [*(right for _, right in q.pairs), *q.others]
    if target == "qti":  # there a line may hold what any text does
        texts, lines = [*texts, *lines], []
    shown = [unescape(one["address"]) for text in texts for one in SHOWN.finditer(text)]
    if any(target == "gift" or pictures(address) is None for address in shown):
        yield "its pictures are not in the file; add them on the platform"
    if any(map(SHOWN.search, lines)):
        yield "of a picture in a list to choose from, its words are there"
    if any(map(FORMULA.search, lines)):
        yield "formulas in a list to choose from stand there as they are typed"
    if target == "qti" and any(FORMULA.search(with_mathml(text, formulas)) for text in texts):
        yield "its formulas stand there as they are typed"
    if any(map(_OWN_LINK.search, [*texts, *lines])):
        yield "its links lead to pages of this site; change them on the platform"


def _of(q: Portable, target: Target) -> Iterator[str]:
    if q.scene:
        yield f"it is about the scene “{q.scene}”, which stays here: link to the lesson"
    if q.idea:
        yield "the student's first idea is not shown beside it there"
    if q.sure:
        yield "how sure a student is, is not asked there"
    if q.words:
        yield "the words to use are not shown there"
    if q.start and (target != "moodle" or q.shape != "essay"):
        yield "the beginning of the answer is not given there"
    if q.rubric and q.shape == "short" and target != "qti":
        yield "its rubric is not there: the platform marks it by the accepted answers alone"
    if target == "gift":
        said = sum(bool(feedback) for _, _, feedback in q.wrong_numbers)
        if said:
            yield f"feedback on {said} known wrong numbers is not in this format"
        if q.marks != 1:
            yield f"it is worth {q.marks} marks here and 1 there: GIFT knows no marks"
        if q.rubric and q.shape == "essay":
            yield "its rubric is not in this format"
