"""Hand-in codes that a teacher typed from paper: answers like those of a file, without times.

One line each: the code word, the form, the code. The form may be left out where only one fits.

    BLUE-FOX-27 pre 7K2M-Q9ZD-03HX
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from sim.classroom.files.archive import shown
from sim.classroom.files.keyed import KeyedForm
from sim.classroom.files.reading import Read, Refused
from sim.lesson.answer_file import AnswerFile, Item
from sim.lesson.handin import HandInError, decode
from sim.lesson.opening import FORMS
from sim.scene.said import listed_or, reason_of, said, template

_CODE = re.compile(r"[0-9A-Za-z]{4}([- ]?[0-9A-Za-z]{4}){2}\s*$")
MOST_LINES = 2000


def read_codes(text: str, forms: Sequence[KeyedForm]) -> tuple[list[Read], list[Refused]]:
    """The answers behind each line, and the lines that hold none, with the reason."""
    read: list[Read] = []
    refused: list[Refused] = []
    lines = [line for one in text.splitlines() if (line := one.strip())]
    for line in lines[:MOST_LINES]:
        found = _line(line, forms)
        if isinstance(found, str):
            refused.append(Refused(_typed(line), found))
        else:
            read.append(found)
    if rest := lines[MOST_LINES:]:
        reason = said("more than {most} lines: the rest was not read", most=f"{MOST_LINES:,}")
        refused.append(Refused(_typed(rest[0]), reason))
    return read, refused


def _typed(line: str) -> str:
    return said("typed: {line}", line=shown(line)[:60])


def _line(line: str, forms: Sequence[KeyedForm]) -> Read | str:
    match = _CODE.search(line)
    if not match:
        return template(
            "a line is: code word, form, hand-in code; for example BLUE-FOX-27 pre 7K2M-Q9ZD-03HX"
        )
    words = line[: match.start()].replace(",", " ").replace(";", " ").split()
    wanted = words.pop().lower() if words and words[-1].lower() in FORMS else ""
    if not words:
        return template("the student's code word is missing in front of the code")
    fitting = []
    problem = template("there is no key for it: choose the key file as well")
    for form in forms:
        if wanted and form.form != wanted:
            continue
        try:
            chosen = decode(
                [count for _, count in form.options], match.group(), f"{form.form}:{form.hash}"
            )
        except HandInError as error:
            problem = reason_of(error)
        else:
            fitting.append((form, chosen))
    if not fitting:
        return problem
    if len(fitting) > 1:
        names = listed_or([form.form for form, _ in fitting])
        return said("this code fits several forms: write {forms} in front of it", forms=names)
    return _read(" ".join(words), match.group().strip(), *fitting[0])


def _read(student: str, code: str, form: KeyedForm, chosen: Sequence[int]) -> Read:
    items = []
    for (name, _), choice in zip(form.options, chosen, strict=True):
        keyed = form.items[name]
        if choice:
            value = keyed.question.asked()["options"][choice - 1]
            items.append(
                Item(id=name, hash=keyed.hash, type=keyed.question.KIND, value=value, first=None,
                     last=None, tries=0, more={})
            )  # fmt: skip
    answers = AnswerFile(
        site=form.site, lesson=form.lesson, lesson_hash="", student=shown(student)[:60],
        form=form.form, created="", saved="", handed=None, code=code, items=tuple(items),
    )  # fmt: skip
    line = f"{shown(student)[:60]} {form.form}"
    return Read(said("typed: {line}", line=line), answers)
