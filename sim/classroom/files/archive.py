"""Zips from students and platforms, read in memory with bounds; nothing is unpacked to a disk.

What a zip claims is not believed: entries are counted before a list is made of them, bytes while
they come. No name in it is ever used as a path.
"""

from __future__ import annotations

import io
import zipfile
import zlib
from collections.abc import Iterator
from dataclasses import dataclass

from sim.classroom.files import keyed, marks_file
from sim.lesson.answer_file import MOST_BYTES
from sim.scene.said import reason_of, said, template

LARGEST = max(MOST_BYTES, keyed.MOST_CHARACTERS, marks_file.MOST_CHARACTERS)
"""Bytes of a file of any kind; who reads it knows the kind, and looks at that kind's own limit."""

MOST_ENTRIES = 20_000
"""Entries of one zip, folders included."""

MOST_UNPACKED = 400_000_000
"""Bytes of one zip, unpacked: 5,000 files of 50 kB are 250 MB."""

LONGEST_NAME = 200
READ_AT_ONCE = 1 << 16
_ENCRYPTED = 0x1
_IGNORED = ("/__MACOSX/", "/.DS_Store", "/Thumbs.db", "/desktop.ini", "/._")
"""What computers put beside files: `._ANNA.json` lies beside ANNA.json where a Mac wrote it."""


PASSWORD = template("this file has a password: make the zip without one")
PACKED = template("this zip is packed in a way that is not known here: make an ordinary one")
TOO_LARGE = template("this file is too large to be a file of answers")
TOO_MUCH = template("this zip unpacks to far too much: the rest was not read")


@dataclass(frozen=True, slots=True)
class Entry:
    """A file in a zip under its shown name; without `content` there is a `reason`."""

    name: str
    content: bytes | None
    reason: str = ""


def is_zip(content: bytes) -> bool:
    """Whether the bytes begin like a zip; the name of a file proves nothing."""
    return content[:4] in (b"PK\x03\x04", b"PK\x05\x06", b"PK\x07\x08")


def is_aside(name: str) -> bool:
    """Whether a file of this name was put there by a computer, and by nobody."""
    return any(part in f"/{name}" for part in _IGNORED)


def entries(name: str, content: bytes, *, deep: bool = True) -> Iterator[Entry]:
    """What is in a zip, file by file; `name`: the zip's own.

    `deep`: a zip in it is opened as well, once: that is how platforms pack what students zipped.
    """
    name = shown(name)
    try:
        _check_entries(content)
        archive = zipfile.ZipFile(io.BytesIO(content))
    except _DamagedError as error:
        yield Entry(name, None, reason_of(error))
        return
    except (zipfile.BadZipFile, ValueError, OSError, NotImplementedError, IndexError):
        yield Entry(name, None, template("this zip is damaged: make it again"))
        return
    unpacked = 0
    with archive:
        for entry in archive.infolist():
            if entry.is_dir() or is_aside(entry.filename):
                continue
            found, reason = _content(archive, entry)
            unpacked += len(found or b"")
            if unpacked > MOST_UNPACKED:
                yield Entry(name, None, TOO_MUCH)
                return
            inner = f"{name}/{shown(entry.filename)}"
            if deep and found is not None and is_zip(found):
                for one in entries(inner, found, deep=False):
                    unpacked += len(one.content or b"")
                    if unpacked > MOST_UNPACKED:
                        yield Entry(name, None, TOO_MUCH)
                        return
                    yield one
            else:
                yield Entry(inner, found, reason)


class _DamagedError(ValueError):
    """A zip that is not even opened."""


def _too_many() -> str:
    return said("this zip has more than {most} entries: that is no class", most=f"{MOST_ENTRIES:,}")


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
        raise _DamagedError(_too_many())
    # A record that tells less than there is: each entry of the list takes at least 46 bytes.
    if content.count(b"PK\x01\x02") > 2 * MOST_ENTRIES:
        raise _DamagedError(_too_many())


def _content(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> tuple[bytes | None, str]:
    """The bytes of an entry, or the reason why there are none. What it claims is not believed."""
    if entry.flag_bits & _ENCRYPTED:
        return None, PASSWORD
    if entry.file_size > LARGEST:
        return None, TOO_LARGE
    if entry.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        return None, PACKED
    parts, size = [], 0
    try:
        with archive.open(entry) as stream:
            while part := stream.read(READ_AT_ONCE):
                size += len(part)
                if size > LARGEST:
                    return None, TOO_LARGE
                parts.append(part)
    except (zipfile.BadZipFile, zlib.error, EOFError, OSError, ValueError, NotImplementedError):
        return None, template("this file in the zip is damaged")
    except RuntimeError:
        return None, PASSWORD
    return b"".join(parts), ""


def shown(name: str) -> str:
    """A name as it is shown: one line of printable characters, not too long."""
    text = "".join(c if c.isprintable() else "·" for c in name.replace("\\", "/"))
    if len(text) > LONGEST_NAME:
        text = f"{text[: LONGEST_NAME // 2]}…{text[-LONGEST_NAME // 2 :]}"
    return text or "(no name)"
