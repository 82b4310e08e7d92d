"""Where files come from: other wordings, other versions, other sites, nobody, or a mistake."""

from __future__ import annotations

from collections.abc import Sequence

from sim.classroom.report.flags.flag import Flag
from sim.classroom.report.marked import Marked
from sim.classroom.report.numerals import numbers
from sim.scene.said import counted, said

NAMED = 5
"""Sites that a question names."""


def foreign(files: Sequence[Marked]) -> list[Flag]:
    """Answers to other wordings, and files of other sites."""
    flags = [*_wordings(files), *_versions(files)]
    sites = sorted({file.file.site for file in files})
    if len(sites) > 1:
        most = max(sites, key=lambda site: sum(f.file.site == site for f in files))
        strangers = tuple(file.name for file in files if file.file.site != most)
        text = said(
            "Files of {n} sites: {sites}. Did all students use the same copy of the lessons? Each "
            "site has tables of its own.",
            n=f"{len(sites)}", sites=", ".join(sites[:NAMED]),
        )  # fmt: skip
        flags.append(Flag("foreign-site", text, strangers))
    return flags


def _wordings(files: Sequence[Marked]) -> list[Flag]:
    """Files that answer another text than the key's, form by form: what fits is counted."""
    by_form: dict[tuple[str, str, str], list[Marked]] = {}
    for file in files:
        if file.foreign:
            f = file.file
            by_form.setdefault((f.site, f.lesson, f.form), []).append(file)
    flags = []
    for (_, lesson, form), found in by_form.items():
        asked = sorted({number for file in found for number in file.foreign_numbers})
        text = counted(
            "1 file ({lesson}, form {form}) answers another text of these questions than the key "
            "has: {questions}. These answers are not counted and the file has no total; its other "
            "answers are counted. Was the lesson changed meanwhile? Add the key file of the other "
            "text too: each file is marked by the key that fits it.",
            "{n} files ({lesson}, form {form}) answer another text of these questions than the key "
            "has: {questions}. These answers are not counted and the files have no total; their "
            "other answers are counted. Was the lesson changed meanwhile? Add the key file of the "
            "other text too: each file is marked by the key that fits it.",
            n=len(found), lesson=lesson, form=form, questions=numbers(asked),
        )  # fmt: skip
        flags.append(Flag("foreign-version", text, tuple(file.name for file in found)))
    return flags


def _versions(files: Sequence[Marked]) -> list[Flag]:
    """Files from another version of a lesson than most: what still fits is counted."""
    by_lesson: dict[tuple[str, str], dict[str, list[str]]] = {}
    for file in files:
        f = file.file
        if f.lesson_hash:
            versions = by_lesson.setdefault((f.site, f.lesson), {})
            versions.setdefault(f.lesson_hash, []).append(file.name)
    flags = []
    for (_, lesson), versions in by_lesson.items():
        if len(versions) > 1:
            most = max(versions.values(), key=len)
            others = tuple(n for names in versions.values() if names is not most for n in names)
            text = said(
                "{n} versions of the lesson {lesson}. Was it changed meanwhile, or do students "
                "have different copies? Answers to unchanged questions are counted.",
                n=f"{len(versions)}", lesson=lesson,
            )  # fmt: skip
            flags.append(Flag("other-version", text, others))
    return flags


def told_right(files: Sequence[Marked]) -> list[Flag]:
    """Answers that the page told to be right, and the key does not: one of the two was changed."""
    by_form: dict[tuple[str, str], dict[int, list[Marked]]] = {}
    for file in files:
        for number, answer in enumerate(file.answers.values(), 1):
            told = answer.item is not None and answer.item.right
            if told and answer.mark and answer.mark.verdict == "wrong" and not answer.foreign:
                asked = by_form.setdefault((file.file.lesson, file.file.form), {})
                asked.setdefault(number, []).append(file)
    flags = []
    for (lesson, form), asked in by_form.items():
        for number, found in asked.items():
            text = counted(
                "Question {number} ({lesson}, form {form}): the page told 1 student that the "
                "answer is right, and the key says wrong. Was the answer changed after the lesson? "
                "Then mark with the key of then.",
                "Question {number} ({lesson}, form {form}): the page told {n} students that their "
                "answer is right, and the key says wrong. Was the answer changed after the lesson? "
                "Then mark with the key of then.",
                n=len(found), number=f"{number}", lesson=lesson, form=form,
            )  # fmt: skip
            flags.append(Flag("told-right", text, tuple(file.name for file in found)))
    return flags


def nameless(files: Sequence[Marked]) -> list[Flag]:
    """Files that say nothing of whose they are."""
    names = tuple(file.name for file in files if not file.file.student.strip())
    if not names:
        return []
    text = counted(
        "1 file has no code word: it counts as a person of its own. Do you know whose it is? Then "
        "give it a code word.",
        "{n} files have no code word: each counts as a person of its own. Do you know whose they "
        "are? Then give them a code word.",
        n=len(names),
    )
    return [Flag("no-code", text, names)]


def unanswered(files: Sequence[Marked]) -> list[Flag]:
    """Files in which nothing is answered: saved by mistake, one counts as a test with no marks."""
    names = tuple(file.name for file in files if file.unanswered)
    if not names:
        return []
    text = counted(
        "Nothing is answered in 1 file; it is counted, with no marks. Did this student hand in the "
        "wrong file? Then leave it out, or ask for the right one.",
        "Nothing is answered in {n} files; they are counted, with no marks. Did these students "
        "hand in the wrong file? Then leave them out, or ask for the right ones.",
        n=len(names),
    )
    return [Flag("unanswered", text, names)]
