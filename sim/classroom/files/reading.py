"""Many answer files read at once: single files, folders' worth of them, and zips.

Everything is bounded before it is read: bytes, entries, depth (zips: archive.py). A bad file is
named with the reason and the others are read on.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from sys import intern
from typing import TypeGuard

from sim.classroom.files.archive import LARGEST, TOO_LARGE, Entry, entries, is_aside, is_zip, shown
from sim.classroom.files.keyed import KeyedForm, KeyFileError, read_key_file
from sim.classroom.files.marks_file import KIND as MARKS
from sim.classroom.files.marks_file import Given, MarksFileError, read_marks
from sim.classroom.files.nameless import Names
from sim.lesson.answer_file import (
    NO_QUESTIONS,
    AnswerFile,
    AnswerFileError,
    Item,
    read_answer_file,
)
from sim.lesson.key_file import KIND as KEY
from sim.scene.said import reason_of, said, template

MOST_FILES = 20_000
"""Files of one reading: a year of a large school."""

MOST_NAMED = 200
"""Refused files that are named one by one; beyond, they are counted."""

_NOTHING: dict[str, str] = {}  # one for all


@dataclass(frozen=True, slots=True)
class Source:
    """A file as it came: its name, for people only, and its bytes."""

    name: str
    content: bytes


@dataclass(frozen=True, slots=True)
class Refused:
    """A file that is not counted, and why."""

    name: str
    reason: str


@dataclass(frozen=True, slots=True)
class Read:
    """A file of answers under the name it came with, with the words of predictions."""

    name: str
    answers: AnswerFile


Outcome = Read | Refused | tuple[KeyedForm, ...] | Given


@dataclass(slots=True)
class Reading:
    """Everything that was read: answers, keys, a teacher's own marks, and what was refused."""

    files: list[Read]
    keys: list[KeyedForm]
    refused: list[Refused]
    given: dict[tuple[str, str, str, str], int]
    names: Names = field(default_factory=Names)

    @staticmethod
    def of(sources: Iterable[Source]) -> Reading:
        """Reads all sources, in their order."""
        reading = Reading([], [], [], {})
        for outcome in outcomes(sources):
            reading.add(outcome)
        return reading

    def add(self, outcome: Outcome) -> None:
        """Files the outcome of one file."""
        if isinstance(outcome, Read):
            self.files.append(self._distinct(outcome))
        elif isinstance(outcome, Refused):
            self.refused.append(outcome)
        elif isinstance(outcome, tuple):
            self.keys += outcome
        else:
            self.given |= outcome

    def _distinct(self, read: Read) -> Read:
        """The file; one without a code word has a name of its own."""
        if read.answers.student.strip():
            return read
        return replace(read, name=self.names.of(read.name, read.answers.created))

    def name(self, students: Mapping[str, str]) -> None:
        """Gives files that have no code word one, by the name of the file or the end of it."""
        self.files = [named(read, students) for read in self.files]


def named(read: Read, students: Mapping[str, str]) -> Read:
    """The file with the code word that its name or the end of it is given, if it has none."""
    code = next(
        (code for name, code in students.items() if f"/{read.name}".endswith(f"/{name}")), ""
    )
    if not code or read.answers.student.strip():
        return read
    return replace(read, answers=replace(read.answers, student=code))


def outcomes(sources: Iterable[Source], most: int = MOST_FILES, skip: int = 0) -> Iterator[Outcome]:
    """One outcome for each file, zips entry by entry; `most`: files that are read.

    `skip`: outcomes that are known; what these files hold is not looked at again.
    """
    count = 0
    for source in sources:
        for entry in _entries_of(source):
            count += 1
            if count > most:
                reason = said("more than {most} files: the rest was not read", most=f"{most:,}")
                yield Refused(shown(source.name), reason)
                return
            if count <= skip:
                continue
            if entry.content is None:
                yield Refused(entry.name, entry.reason)
            else:
                yield of_file(entry.name, entry.content)


def _entries_of(source: Source) -> Iterator[Entry]:
    if is_aside(source.name):
        return iter(())
    if is_zip(source.content):
        return entries(source.name, source.content)
    return iter([Entry(source.name, source.content)])


def of_file(name: str, content: bytes) -> Outcome:
    """What one file that is no zip holds."""
    name = shown(name)
    if len(content) > LARGEST:
        return Refused(name, TOO_LARGE)
    if is_zip(content):
        return Refused(name, template("too many zips inside each other: unpack them first"))
    try:
        text = content.decode("utf-16" if content[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8")
    except UnicodeDecodeError:
        return Refused(name, template("this is no text file, so it holds no answers"))
    try:
        return _of_text(name, text)
    except Exception as error:  # whatever one file does, the others of the class are read
        kind = type(error).__name__
        return Refused(name, said("this file cannot be read ({error})", error=kind))


def _of_text(name: str, text: str) -> Outcome:
    try:
        return Read(name, _slim(read_answer_file(text)))
    except AnswerFileError as error:
        return _of_teacher(name, text, reason_of(error))


def _of_teacher(name: str, text: str, otherwise: str) -> Outcome:
    """A key or marks, or the reason why the file is no file of answers either."""
    try:
        if f'"{MARKS}"' in text:
            return read_marks(text)
        return read_key_file(text) if f'"{KEY}"' in text else Refused(name, otherwise)
    except (MarksFileError, KeyFileError) as error:
        return Refused(name, reason_of(error))


def _slim(answers: AnswerFile) -> AnswerFile:
    """Without what no statistic looks at, such as the text of every question: of 5,000 files.

    What is the same in all files of a class is kept once.
    """
    return replace(
        answers,
        items=tuple(
            replace(
                item,
                id=intern(item.id),
                hash=intern(item.hash),
                type=intern(item.type),
                value=intern(item.value) if _is_short(item.value) else item.value,
                more=_kept(item),
            )
            for item in answers.items
        ),
    )


def _kept(item: Item) -> Mapping[str, str]:
    """What is kept beside the value: of predictions, which no key describes, all of `more`; else
    only how sure the student was."""
    if item.type in NO_QUESTIONS:
        return item.more
    return {"sure": intern(item.more["sure"])} if "sure" in item.more else _NOTHING


def _is_short(value: object) -> TypeGuard[str]:
    return isinstance(value, str) and len(value) < 20
