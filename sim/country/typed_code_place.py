"""A typed code stands beside the files of its student: it belongs where they do."""

from __future__ import annotations

from collections.abc import Collection
from typing import Generic, TypeVar

from sim.classroom.files.marks_file import pseudonym
from sim.classroom.files.reading import Read
from sim.scene.said import template

P = TypeVar("P")


class Beside(Generic[P]):
    """The places of students by their files. `only`: students who are asked about; None: all."""

    def __init__(self, only: Collection[str] | None = None) -> None:
        self._only = only
        self._places: dict[str, set[P]] = {}

    def add(self, read: Read, place: P) -> None:
        """Notes where a file stands."""
        student = student_of(read)
        if student and (self._only is None or student in self._only):
            self._places.setdefault(student, set()).add(place)

    def of(self, read: Read) -> P | None:
        """Where the files of the student stand whose code this is; None: nowhere, or in several
        places, or it is a file itself."""
        found = self._places.get(student_of(read), set()) if is_typed(read) else set()
        return next(iter(found)) if len(found) == 1 else None


def student_of(read: Read) -> str:
    """The code word as it is compared."""
    return pseudonym(read.answers.student)


def is_typed(read: Read) -> bool:
    """Whether these answers are those of a hand-in code: they have no times."""
    return bool(read.answers.code) and not read.answers.created


def no_group(read: Read) -> str:
    """Why these answers are in no group."""
    if is_typed(read):
        return template(
            "this code is in none of the groups: no pattern fits the file that it stands in, and "
            "its student has no file in one group alone"
        )
    return template("this file is in none of the groups")
