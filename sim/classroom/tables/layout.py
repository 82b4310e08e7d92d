"""What each column of a table is: found by its heading, in the words of several languages."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sim.classroom.statistics.spread import Exact
from sim.classroom.tables.words import TIMES

_PREFIX = re.compile(r"([^\s._:-]+(?:-test)?)[\s._:-]+(.+)")
_SUFFIX = re.compile(r"(.+?)[\s._:-]+([^\s._:-]+)")


@dataclass(frozen=True, slots=True)
class Column:
    """A column of marks: its place, the name of the question, its form, its most marks if told."""

    place: int
    name: str
    form: str = ""
    of: Exact | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Layout:
    """Which column is what. `student`: columns that name a person, the first filled one counts;
    each may be several, joined. `ends`: columns that are empty in rows that sum up others.
    """

    kind: str
    student: tuple[tuple[int, ...], ...] = ()
    group: int | None = None
    klass: int | None = None
    time: int | None = None
    item: int | None = None
    items: tuple[Column, ...] = ()
    totals: tuple[Column, ...] = ()
    state: int | None = None
    needs: tuple[int, ...] = ()
    left_out: tuple[str, ...] = ()


def norm(heading: str) -> str:
    """A heading as it is compared."""
    text = unicodedata.normalize("NFKC", heading).casefold().replace("_", " ")
    return " ".join(text.strip("\ufeff *:?").split())


def place_of(heads: Sequence[str], names: Iterable[str]) -> int | None:
    """The first column with one of these headings."""
    wanted = set(names)
    return next((k for k, head in enumerate(heads) if norm(head) in wanted), None)


def form_of(text: str) -> str:
    """pre, post or delayed for a word that means it; empty for others."""
    word = norm(text)
    return next((form for form, words in TIMES.items() if word in words), "")


def form_told(cell: str) -> str:
    """The same, of what a row says of itself: “Before the lessons” too."""
    return form_of(cell) or form_of(next(iter(cell.split()), ""))


def split_form(name: str) -> tuple[str, str]:
    """`pre_Q1` and `Q1 (post)` are Q1 of a form; other names have none."""
    before, after = _PREFIX.fullmatch(name), _SUFFIX.fullmatch(name)
    if before and (form := form_of(before[1])):
        return form, before[2].strip()
    if after and (form := form_of(after[2].strip("()[]"))):
        return form, after[1].strip()
    return "", name
