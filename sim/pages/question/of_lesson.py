"""What a lesson asks, read from its text without building a page: for its key and for exports."""

from __future__ import annotations

from dataclasses import dataclass

from sim.lesson import Question
from sim.lesson.form import Form
from sim.lesson.kinds.run import Reading
from sim.pages.blocks.scene_block import Lesson, SiteIds, read_scene_block
from sim.pages.findings import AuthorError
from sim.pages.question.block import read_question_block
from sim.pages.question.on_page import BEFORE_A_RUN, watched_by
from sim.pages.question.quiz import read_quiz_block
from sim.pages.text.fence_scan import Block, after_front_matter, scan
from sim.pages.text.plain_lines import lines_of
from sim.pages.text.sections import in_sections, title_of
from sim.scene import Fence

WORKSHEET = "worksheet"
"""The form of the questions that stand in the lesson itself."""


@dataclass(frozen=True, slots=True)
class LessonAsks:
    """Questions of the lesson's own, and its forms, in their order.

    `title`: its first heading, may be empty. `about`: ids of own questions, each with the id of
    the scene that it is about. `predicted`: ids of scenes that ask for a prediction. `optional`:
    ids of own questions in parts for who has time. `scenes`: what can be read of them, by id.
    """

    title: str
    own: tuple[Question, ...]
    forms: tuple[Form, ...]
    about: dict[str, str]
    predicted: tuple[str, ...]
    optional: frozenset[str]
    scenes: dict[str, Fence]

    @property
    def parts(self) -> dict[str, tuple[Question, ...]]:
        """Questions by form, the worksheet first; without what has none."""
        own = {WORKSHEET: self.own} if self.own else {}
        return own | {form.form: form.items for form in self.forms}


def lesson_asks(text: str, lesson: Lesson) -> LessonAsks:
    """What the lesson in `text` asks; raises `AuthorError` with the first block that is wrong."""
    ids = SiteIds()
    own: list[Question] = []
    forms: list[Form] = []
    about: dict[str, str] = {}
    scenes: dict[str, Fence] = {}
    last = ""  # the scene with a prediction that the text since the last heading is about
    optional: set[str] = set()
    lines = lines_of(text)
    title = title_of(lines[after_front_matter(lines) :])
    for block, section in in_sections(lines, scan(lines)):
        last = "" if section.new else last
        if block.name == "scene" and (fence := _read(block, lesson)):
            scenes[fence.id] = fence
            last = fence.id if fence.predict else last
        elif block.name == "question":
            question = read_question_block(block, lesson, ids, first_line=1).question
            own.append(question)
            if section.optional:
                optional.add(question.id)
            if scene := _scene_of(question, last):
                about[question.id] = scene
        elif block.name == "quiz":
            forms.append(read_quiz_block(block, lesson, ids, first_line=1).form)
    predicted = tuple(name for name, fence in scenes.items() if fence.predict)
    return LessonAsks(title, tuple(own), tuple(forms), about, predicted,
                      frozenset(optional), scenes)  # fmt: skip


def _scene_of(question: Question, last: str) -> str:
    """The scene that is watched before a question, or that it reads from."""
    if isinstance(question, Reading):
        return question.scene
    if after := question.common.after:
        return watched_by(after)
    return "" if question.KIND in BEFORE_A_RUN else last


def _read(block: Block, lesson: Lesson) -> Fence | None:
    """None for a scene that cannot be read: `carts check` names what is wrong with it."""
    try:
        return read_scene_block(block, lesson, SiteIds(), first_line=1).fence
    except AuthorError:
        return None
