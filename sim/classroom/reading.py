"""Many answer files read at once: single files, folders' worth of them, and zips.

Nothing is unpacked to a disk and no name in an archive is ever used as a path. Everything is
bounded before it is read: bytes, entries, depth. A bad file is named with the reason and the others
are read on.
"""

from __future__ import annotations

import io
import zipfile
import zlib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from sys import intern
from typing import TypeGuard

from sim.classroom.keyed import KeyedForm, KeyFileError, read_key_file
from sim.classroom.marks_file import KIND as MARKS
from sim.classroom.marks_file import Given, MarksFileError, read_marks
from sim.lesson.answer_file import MOST_BYTES, AnswerFile, AnswerFileError, read_answer_file

MOST_FILES = 20_000
"""Files of one reading: a year of a large school."""

MOST_ENTRIES = 20_000
"""Entries of one zip, folders included."""

MOST_UNPACKED = 400_000_000
"""Bytes of one zip, unpacked: 5,000 files of 50 kB are 250 MB."""

MOST_NAMED = 200
"""Refused files that are named one by one; beyond, they are counted."""

LONGEST_NAME = 200
READ_AT_ONCE = 1 << 16
_ENCRYPTED = 0x1
_NOTHING: dict[str, str] = {}  # one for all
_IGNORED = ("__MACOSX/", ".DS_Store", "Thumbs.db", "desktop.ini")


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
    """A file of answers under the name it came with. Of texts beside the answers only `sure`."""

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
            self.files.append(outcome)
        elif isinstance(outcome, Refused):
            self.refused.append(outcome)
        elif isinstance(outcome, tuple):
            self.keys += outcome
        else:
            self.given |= outcome


def outcomes(sources: Iterable[Source]) -> Iterator[Outcome]:
    """One outcome for each file, zips entry by entry."""
    count = 0
    for source in sources:
        for outcome in _of_source(source):
            count += 1
            if count > MOST_FILES:
                reason = f"more than {MOST_FILES:,} files: the rest was not read"
                yield Refused(shown(source.name), reason)
                return
            yield outcome


def is_zip(content: bytes) -> bool:
    """Whether the bytes begin like a zip; the name of a file proves nothing."""
    return content[:4] in (b"PK\x03\x04", b"PK\x05\x06", b"PK\x07\x08")


def _of_source(source: Source) -> Iterator[Outcome]:
    if is_zip(source.content):
        yield from _of_zip(source)
    else:
        yield of_file(source.name, source.content)


def of_file(name: str, content: bytes) -> Outcome:
    """What one file that is no zip holds."""
    name = shown(name)
    if len(content) > MOST_BYTES:
        return Refused(name, "this file is too large to be a file of answers")
    if is_zip(content):
        return Refused(name, "a zip inside a zip: unpack it first, and choose what is in it")
    try:
        text = content.decode("utf-16" if content[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8")
    except UnicodeDecodeError:
        return Refused(name, "this is no text file, so it holds no answers")
    try:
        return Read(name, _slim(read_answer_file(text)))
    except AnswerFileError as error:
        return _of_teacher(name, text, str(error))


def _of_teacher(name: str, text: str, otherwise: str) -> Outcome:
    """A key or marks, or the reason why the file is no file of answers either."""
    try:
        return read_marks(text) if f'"{MARKS}"' in text else read_key_file(text)
    except MarksFileError as error:
        return Refused(name, str(error))
    except KeyFileError as error:
        return Refused(name, str(error) if '"newtons-carts-key"' in text else otherwise)


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
                more={"sure": intern(item.more["sure"])} if "sure" in item.more else _NOTHING,
            )
            for item in answers.items
        ),
    )


def _is_short(value: object) -> TypeGuard[str]:
    return isinstance(value, str) and len(value) < 20


def _of_zip(source: Source) -> Iterator[Outcome]:
    name = shown(source.name)
    try:
        _check_entries(source.content)
        archive = zipfile.ZipFile(io.BytesIO(source.content))
    except _DamagedError as error:
        yield Refused(name, str(error))
        return
    except (zipfile.BadZipFile, ValueError, OSError, NotImplementedError, IndexError):
        yield Refused(name, "this zip is damaged: make it again")
        return
    unpacked = 0
    with archive:
        for entry in archive.infolist():
            if entry.is_dir() or any(part in entry.filename for part in _IGNORED):
                continue
            inside = f"{name}/{shown(entry.filename)}"
            content, reason = _content(archive, entry)
            if content is None:
                yield Refused(inside, reason)
                continue
            unpacked += len(content)
            if unpacked > MOST_UNPACKED:
                yield Refused(name, "this zip unpacks to far too much: the rest was not read")
                return
            yield of_file(inside, content)


class _DamagedError(ValueError):
    """A zip that is not even opened."""


def _check_entries(content: bytes) -> None:
    """Refuses a zip with far too many entries, before anything is built from its list.

    The list of a million entries would fill the memory: it is judged by its own end record.
    """
    at = content.rfind(b"PK\x05\x06", max(0, len(content) - 65_600))
    if at < 0 or at + 22 > len(content):
        raise _DamagedError("this zip is damaged or cut short: make it again")
    count = int.from_bytes(content[at + 10 : at + 12], "little")
    size = int.from_bytes(content[at + 12 : at + 16], "little")
    wide = count == 0xFFFF or size == 0xFFFF_FFFF
    if wide or count > MOST_ENTRIES or size > 1_000 * MOST_ENTRIES:
        raise _DamagedError(f"this zip has more than {MOST_ENTRIES:,} entries: that is no class")
    # A record that tells less than there is: each entry of the list takes at least 46 bytes.
    if content.count(b"PK\x01\x02") > 2 * MOST_ENTRIES:
        raise _DamagedError(f"this zip has more than {MOST_ENTRIES:,} entries: that is no class")


def _content(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> tuple[bytes | None, str]:
    """The bytes of an entry, or the reason why there are none. What it claims is not believed."""
    if entry.flag_bits & _ENCRYPTED:
        return None, "this file has a password: make the zip without one"
    if entry.file_size > MOST_BYTES:
        return None, "this file is too large to be a file of answers"
    if entry.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        return None, "this zip is packed in a way that is not known here: make an ordinary one"
    parts, size = [], 0
    try:
        with archive.open(entry) as stream:
            while part := stream.read(READ_AT_ONCE):
                size += len(part)
                if size > MOST_BYTES:
                    return None, "this file is too large to be a file of answers"
                parts.append(part)
    except (zipfile.BadZipFile, zlib.error, EOFError, OSError, ValueError, NotImplementedError):
        return None, "this file in the zip is damaged"
    except RuntimeError:
        return None, "this file has a password: make the zip without one"
    return b"".join(parts), ""


def shown(name: str) -> str:
    """A name as it is shown: one line of printable characters, not too long."""
    text = "".join(c if c.isprintable() else "·" for c in name.replace("\\", "/"))
    if len(text) > LONGEST_NAME:
        text = f"{text[: LONGEST_NAME // 2]}…{text[-LONGEST_NAME // 2 :]}"
    return text or "(no name)"
