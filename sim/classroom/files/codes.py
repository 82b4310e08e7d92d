"""Hand-in codes that a teacher typed from paper: answers like those of a file, without times.

One line each: the code word, the form, the code. The form may be left out where only one fits; of
two lessons with the same questions the one that is meant is written in front of the form.

    BLUE-FOX-27 pre 7K2M-Q9ZD-03HX
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from difflib import get_close_matches

from sim.classroom.files.archive import shown
from sim.classroom.files.keyed import KeyedForm
from sim.classroom.files.reading import Read, Refused
from sim.lesson.answer_file import AnswerFile, Item
from sim.lesson.handin import HandInError, decode
from sim.lesson.opening import FORMS
from sim.scene.said import listed_or, reason_of, said, template

_CODE = re.compile(r"[0-9A-Za-z]{4}([- ]?[0-9A-Za-z]{4}){2}\s*$")
_BETWEEN = re.compile("[,;]")
MOST_LINES = 2000
ALIKE = 0.8
"""A last word this much like the name of a lesson is taken for a misspelt one."""


def read_codes(
    text: str, forms: Sequence[KeyedForm], file: str = ""
) -> tuple[list[Read], list[Refused]]:
    """The answers behind each line, and the lines that hold none, with the reason.

    `file`: where the text is from; each line is then called like a file in this one.
    """
    read: list[Read] = []
    refused: list[Refused] = []
    lines = [(n, line) for n, one in enumerate(text.splitlines(), 1) if (line := one.strip())]
    for n, line in lines[:MOST_LINES]:
        found = _line(line, forms)
        if isinstance(found, str):
            refused.append(Refused(_name(line, n, file), found))
        else:
            told = f"{found.student} {found.form}"
            read.append(Read(_name(told, n, file), found))
    if rest := lines[MOST_LINES:]:
        reason = said("more than {most} lines: the rest was not read", most=f"{MOST_LINES:,}")
        refused.append(Refused(_name(rest[0][1], rest[0][0], file), reason))
    return read, refused


def _name(line: str, n: int, file: str) -> str:
    told = shown(line)[:60]
    if file:
        return said("{file}/line {n}: {line}", file=shown(file), n=f"{n}", line=told)
    return said("typed, line {n}: {line}", n=f"{n}", line=told)


def _line(line: str, forms: Sequence[KeyedForm]) -> AnswerFile | str:
    match = _CODE.search(line)
    if not match:
        return template(
            "a line is: code word, form, hand-in code; for example BLUE-FOX-27 pre 7K2M-Q9ZD-03HX"
        )
    told = _who(line[: match.start()], [form.lesson for form in forms])
    if isinstance(told, str):
        return told
    student, lesson, wanted = told
    fits: dict[tuple[str, str, str], tuple[KeyedForm, Sequence[int]]] = {}
    problem = template("there is no key for it: choose the key file as well")
    for form in forms:
        if lesson not in ("", form.lesson):
            continue
        try:
            chosen = decode(
                [count for _, count in form.options], match.group(), f"{form.form}:{form.hash}"
            )
        except HandInError as error:
            problem = reason_of(error) if wanted in ("", form.form) else problem
        else:
            # A form whose key is there twice, or in two copies of a site, is one: the later counts.
            fits[form.lesson, form.form, form.hash] = form, chosen
    meant = [one for one in fits if wanted in ("", one[1])]
    if len(meant) == 1:
        return _read(student, match.group().strip(), *fits[meant[0]])
    names = list(dict.fromkeys(f"{lesson} {form}" for lesson, form, _ in meant))
    if len(names) > 1:
        forms_ = listed_or(names)
        return said("this code fits several forms: write {forms} in front of it", forms=forms_)
    if names:
        return template(
            "this code fits several texts of this form: choose only the key of the text that was "
            "answered"
        )
    return problem


def _who(text: str, lessons: Sequence[str]) -> tuple[str, str, str] | str:
    """Code word, lesson and form in front of a code, the last two perhaps empty; or what is wrong.

    A code word may have blanks: a misspelt lesson is known by commas only, or by what it is like.
    """
    fields = [words for field in _BETWEEN.split(text) if (words := field.split())]
    words = [word for field in fields for word in field]
    form = words.pop().lower() if words and words[-1].lower() in FORMS else ""
    if not words:
        return template("the student's code word is missing in front of the code")
    before = " ".join(words)
    known = {lesson.lower(): lesson for lesson in lessons}
    if before.lower() in known:
        return template("the student's code word is missing in front of the code")
    for small in sorted(known, key=len, reverse=True):
        if before.lower().endswith(f" {small}"):
            return before[: -len(small) - 1], known[small], form
    apart = words[len(fields[0]) :]
    if not apart and len(words) > 1 and get_close_matches(words[-1].lower(), known, 1, ALIKE):
        apart = words[-1:]
    if not apart or not known:
        return before, "", form
    return said(
        "there is no key for a lesson “{name}”, only for {lessons}; a comma ends the code word",
        name=shown(" ".join(apart))[:60], lessons=listed_or(sorted(known.values())),
    )  # fmt: skip


def _read(student: str, code: str, form: KeyedForm, chosen: Sequence[int]) -> AnswerFile:
    items = []
    for (name, _), choice in zip(form.options, chosen, strict=True):
        keyed = form.items[name]
        if choice:
            value = keyed.question.asked()["options"][choice - 1]
            items.append(
                Item(id=name, hash=keyed.hash, type=keyed.question.KIND, value=value, first=None,
                     last=None, tries=0, more={})
            )  # fmt: skip
    return AnswerFile(
        site=form.site, lesson=form.lesson, lesson_hash="", student=shown(student)[:60],
        form=form.form, created="", saved="", handed=None, code=code, items=tuple(items),
    )  # fmt: skip
