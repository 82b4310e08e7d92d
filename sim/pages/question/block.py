"""A `question` block of a lesson: from its text to a question, or to the author's mistakes."""

from __future__ import annotations

from dataclasses import dataclass

from sim.lesson import LessonError, Question, read_question
from sim.pages.blocks.scene_block import Lesson, Places, SiteIds, load_block
from sim.pages.findings import AuthorError, Finding
from sim.pages.text.fence_scan import Block


@dataclass(frozen=True, slots=True)
class QuestionBlock:
    """A question that makes sense; `places` maps later problems back to the author's lines."""

    question: Question
    places: Places


def read_question_block(
    block: Block, lesson: Lesson, ids: SiteIds, *, first_line: int
) -> QuestionBlock:
    """The question of `block`; raises `AuthorError` with everything that is wrong."""
    source = load_block(block, lesson.file, first_line=first_line)
    places = Places(lesson.file, source)
    try:
        question = read_question(source.plain)
    except LessonError as error:
        raise AuthorError(map(places.finding, error.problems)) from None
    ids.claim(question.id, Finding(lesson.file, *source.place(("id",)), "id", ""))
    return QuestionBlock(question, places)
