"""What a question loses on its way to a learning platform, in sentences: nothing goes silently.

What holds for all of them stands in docs/teachers/platform.md: beliefs, hints and scenes stay here.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Literal

from sim.pages.classroom.portable import Portable

Target = Literal["moodle", "gift", "qti"]


def losses(questions: Iterable[Portable], target: Target) -> list[str]:
    """A sentence for each loss, question by question."""
    return [f"{q.id}: {text}" for q in questions for text in _of(q, target)]


def _of(q: Portable, target: Target) -> Iterator[str]:
    texts = [q.ask, q.explain, *(t for a in q.answers for t in (a[0], a[2])), *sum(q.pairs, ())]
    if any("<img" in text for text in texts):
        yield "its pictures are not in the file; add them on the platform"
    if q.sure:
        yield "how sure a student is, is not asked there"
    if target == "gift":
        said = sum(bool(feedback) for _, _, feedback in q.wrong_numbers)
        if said:
            yield f"feedback on {said} known wrong numbers is not in this format"
        if q.marks != 1:
            yield f"it is worth {q.marks} marks here and 1 there: GIFT knows no marks"
        if q.rubric:
            yield "its rubric is not in this format"
