"""What a table says: who took which test with which marks, each with the line it stands in."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sim.classroom.files.marks_file import pseudonym
from sim.classroom.statistics.spread import Exact
from sim.scene.said import said, template

WORTH_SEEN = 1
"""Marks of a question up to which nothing has to be told: it was right, wrong or in between."""

TOTALS_ONLY = template("is for totals; this table has marks of questions, so put a row MAX into it")
"""What the most marks of a test cannot be told of."""

ALONE = template("test")
"""The form of a table that tells of one test only."""


def place_of(table: str, line: int) -> str:
    """A line of a table, for people."""
    return said("{table}, line {line}", table=table, line=f"{line}")


@dataclass(frozen=True, slots=True, kw_only=True)
class Taken:
    """One student in one test. `table`: its name. `items`: marks, None where a question was left
    open.

    `chosen`: options, where the table has letters. `total`: where it has no marks of questions.
    `of`: the most marks, as the cell or the heading tells. Items have theirs in `most`. `apart`:
    the group that the whole table is of; who has the same name in another group is another student.
    """

    table: str
    line: int
    student: str
    group: str
    klass: str
    form: str
    items: Mapping[str, Exact | None]
    most: Mapping[str, Exact]
    chosen: Mapping[str, str]
    total: Exact | None
    of: Exact | None
    apart: str = ""

    @property
    def place(self) -> str:
        """Where the row stands, for people."""
        return place_of(self.table, self.line)

    @property
    def who(self) -> str:
        """The student, for people."""
        return self.student or said("no name ({row})", row=self.place)

    @property
    def person(self) -> str:
        """The student as it is compared; a row without a name is a person of its own."""
        return f"{self.apart}\0{pseudonym(self.student) or self.place}"

    @property
    def marks(self) -> Exact:
        """All marks: what was left open gives none."""
        if self.total is not None:
            return self.total
        return sum((m for m in self.items.values() if m is not None), 0)

    @property
    def content(self) -> Any:
        """What makes two rows the same."""
        return sorted(self.items.items()), sorted(self.chosen.items()), self.total


@dataclass(frozen=True, slots=True, kw_only=True)
class MarkTable:
    """A table as it was read. `keyed`: right answers by item, where a row KEY gives them. `notes`:
    rows that are taken for no student.
    """

    name: str
    kind: str
    rows: int
    taken: tuple[Taken, ...]
    refused: tuple[tuple[str, str], ...]
    left_out: tuple[str, ...]
    keyed: Mapping[str, tuple[str, ...]]
    letters: bool
    groups: bool
    classes: bool
    notes: tuple[str, ...] = ()

    @property
    def of_items(self) -> bool:
        """Are there marks of questions?"""
        return any(row.items for row in self.taken)
