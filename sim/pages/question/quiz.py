"""A `quiz` block: from its text to a form of items drawn from a bank."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from sim.lesson import LessonError
from sim.lesson.bank import Bank, read_bank
from sim.lesson.form import Form, bank_name, read_form
from sim.pages.blocks.scene_block import Lesson, Places, SiteIds, load_block, yaml_findings
from sim.pages.findings import AuthorError, Finding
from sim.pages.text.author_text import author_text, shown_here
from sim.pages.text.fence_scan import Block
from sim.pages.text.lesson_text import text_findings
from sim.pages.text.yaml.source import Plain, YamlError, load
from sim.scene import Problem

FOLDER = "banks"


@dataclass(frozen=True, slots=True)
class QuizBlock:
    """A form that makes sense; `places` maps later problems back to the author's lines."""

    form: Form
    places: Places


def read_quiz_block(block: Block, lesson: Lesson, ids: SiteIds, *, first_line: int) -> QuizBlock:
    """The form of `block`, drawn from its bank; raises `AuthorError`."""
    source = load_block(block, lesson.file, first_line=first_line)
    places = Places(lesson.file, source)
    bank, mistakes = _bank(source.plain, places, lesson)
    try:
        form = read_form(source.plain, bank)
    except LessonError as error:
        raise AuthorError([*mistakes, *map(places.finding, error.problems)]) from None
    if mistakes:
        raise AuthorError(mistakes)
    if leak := _leak(form, ids):
        raise AuthorError([places.finding(leak)])
    ids.claim(form.id, Finding(lesson.file, *source.place(("id",)), "id", ""))
    return QuizBlock(form, places)


def _leak(form: Form, ids: SiteIds) -> Problem | None:
    """An item of an exam whose key stands in another page of the site, or the other way round."""
    own, other = (ids.exam, ids.told) if form.mode == "exam" else (ids.told, ids.exam)
    for item in form.items:
        own[item.hash] = form.id
        if item.hash in other:
            message = f"“{item.id}” is an item of the exam and of the practice form"
            both = f"{form.id} and {other[item.hash]}"
            return Problem(("mode",), "key-in-exam", f"{message} ({both}): its key is in the site",
                           "take other items for practice")  # fmt: skip
    return None


def _bank(
    plain: dict[str, Plain], places: Places, lesson: Lesson
) -> tuple[Bank | None, list[Finding]]:
    name = bank_name(plain)
    if name is None:
        return None, []
    path = find_bank(name, lesson)
    if path is None:
        folders = ", ".join(
            dict.fromkeys(
                f"{folder.parent.name}/{folder.name}".lstrip("/") for folder in lesson.bank_folders
            )
        )
        message = f"there is no bank “{name[:60]}”"
        problem = Problem(("bank",), "no-such-file", message, f"looked in: {folders or FOLDER}")
        return None, [places.finding(problem)]
    shown = shown_here(path)
    try:
        text = lesson.texts.get(path) or author_text(path, shown)
    except AuthorError as error:
        return None, list(error.findings)
    return read_bank_text(text, shown)


def read_bank_text(text: str, file: str) -> tuple[Bank | None, list[Finding]]:
    """The bank in a file and everything that is wrong with it; None if it cannot be read."""
    try:
        source = load(text)
    except YamlError as error:
        return None, yaml_findings(file, error)
    try:
        return read_bank(source.plain), text_findings(text, Lesson(file))
    except LessonError as error:
        return None, sorted(Places(file, source).finding(p) for p in error.problems)


def find_bank(name: str, lesson: Lesson) -> Path | None:
    """The bank's file; never outside of the folders of banks."""
    relative = PurePosixPath(name)
    if relative.is_absolute() or ".." in relative.parts or relative.suffix not in (".yml", ".yaml"):
        return None
    return next((f / relative for f in lesson.bank_folders if (f / relative).is_file()), None)
