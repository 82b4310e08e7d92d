"""Answer files into the table, one at a time: keys first, then every file marked and let go."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain
from pathlib import Path

from sim.classroom.files.archive import entries, is_zip
from sim.classroom.files.codes import read_codes
from sim.classroom.files.keyed import KeyedForm
from sim.classroom.files.marks_file import KIND as MARKS
from sim.classroom.files.reading import Read, Refused, Source, named, of_file, outcomes
from sim.classroom.report.marked import Keys, mark_file
from sim.country.rows import Place, rows_of
from sim.country.typed_code_place import Beside, no_group, student_of
from sim.country.write import TableWriter, new_folder, write_keys
from sim.lesson.key_file import KIND as KEY

MOST_FILES = 10_000_000
"""Files of one table."""

TEACHERS = tuple(
    f'"{kind}"'.encode(code) for kind in (KEY, MARKS) for code in ("utf-8", "utf-16-le",
                                                                    "utf-16-be")
)  # fmt: skip
"""What stands in a file of the teacher's, as bytes."""

Group = Callable[[str], tuple[str, int, str]]
"""Name of a file → its group, the group's place from 1, its class; an empty group: none."""


@dataclass(slots=True)
class Written:
    """What became of the files."""

    files: int = 0
    rows: int = 0
    refused: list[Refused] = field(default_factory=list)


def write_table(
    folder: Path,
    sources: Callable[[], Iterable[Source]],
    group: Group,
    *,
    students: Mapping[str, str] | None = None,
    codes: Sequence[tuple[str, str]] = (),
) -> Written:
    """Reads the sources twice, for keys and for answers; raises `CountryError`.

    `codes`: files of typed ones by name, with what stands in them.
    """
    new_folder(folder)
    keys, given = _of_the_teacher(sources())
    of_files, done = Keys(keys), Written()
    typed: list[Read] = []
    for where, text in codes:
        found, bad = read_codes(text, keys, where)
        typed += found
        done.refused += bad
    beside = Beside[tuple[str, int, str]](only={student_of(read) for read in typed})
    with TableWriter(folder) as table:
        for read in chain(_reads(sources, students or {}, done), typed):
            place = group(read.name)
            if place[0]:
                beside.add(read, place)
            else:
                place = beside.of(read) or place
            name, order, klass = place
            if not name:
                done.refused.append(Refused(read.name, no_group(read)))
                continue
            done.files += 1
            key = of_files.of(read.answers)
            file = mark_file(read, name, key, given)
            table.add(rows_of(file, Place(name, order, klass, done.files), key))
    done.rows = table.rows
    write_keys(folder, keys)
    return done


def _reads(
    sources: Callable[[], Iterable[Source]],
    students: Mapping[str, str],
    done: Written,
) -> Iterator[Read]:
    for outcome in outcomes(sources(), MOST_FILES):
        if isinstance(outcome, Read):
            yield named(outcome, students)
        elif isinstance(outcome, Refused):
            done.refused.append(outcome)


def _of_the_teacher(
    sources: Iterable[Source],
) -> tuple[list[KeyedForm], dict[tuple[str, str, str, str], int]]:
    """Keys and marks; answer files are only looked through for the words that would make them one.

    What cannot be read is named when the answers are read.
    """
    keys: list[KeyedForm] = []
    given: dict[tuple[str, str, str, str], int] = {}
    for source in _single(sources):
        if not any(word in source.content for word in TEACHERS):
            continue
        found = of_file(source.name, source.content)
        if isinstance(found, tuple):
            keys += found
        elif not isinstance(found, (Read, Refused)):
            given |= found
    return keys, given


def _single(sources: Iterable[Source]) -> Iterator[Source]:
    for source in sources:
        if is_zip(source.content):
            for entry in entries(source.name, source.content):
                if entry.content is not None:
                    yield Source(entry.name, entry.content)
        else:
            yield source
