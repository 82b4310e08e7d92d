"""A file as rows of cells: CSV with commas, semicolons or tabs, in any usual encoding.

Nothing is evaluated: a cell is text. A row that is broken is named by its line, the others stay.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import dropwhile, islice

from sim.classroom.tables.figures import COMMAS
from sim.scene.encoded import of_a_spreadsheet
from sim.scene.said import said, template

_UTF_8: Callable[[bytes], str] = partial(str, encoding="utf-8-sig")
_UTF_16: Callable[[bytes], str] = partial(str, encoding="utf-16")

MOST_BYTES = 50_000_000
MOST_ROWS = 200_000
MOST_COLUMNS = 1_000

MOST_LINES = 200
"""Lines of one row: cells may hold lines of their own."""
LOOKED_AT = 20
"""Rows by which the sign between cells is found."""

DELIMITERS = (",", ";", "\t", *COMMAS)
WORKBOOK = template(
    "this is a workbook or a zip, not a table of text: open it and save it as CSV "
    "(File, Save as, CSV UTF-8)"
)


class TableError(ValueError):
    """This is no table of marks, or no mark; the message is for the teacher."""


@dataclass(frozen=True, slots=True)
class TableRow:
    """Cells without spaces around them, and the line of the file where they begin."""

    line: int
    cells: tuple[str, ...]

    def cell(self, place: int | None) -> str:
        """The cell of a column: empty where the row is too short, or there is no such column."""
        return self.cells[place] if place is not None and place < len(self.cells) else ""


@dataclass(frozen=True, slots=True)
class Broken:
    """A row that cannot be split into cells."""

    line: int
    reason: str


class _Lines:
    """Lines for a reader of cells. From a row that is broken it goes on in the next line, however
    far an open quotation mark has led; `start`: where the row begins.
    """

    def __init__(self, lines: list[str]) -> None:
        self.lines, self.start, self.at = lines, 0, 0

    def __iter__(self) -> _Lines:
        return self

    def __next__(self) -> str:
        if self.at == len(self.lines):
            raise StopIteration
        if self.at - self.start == MOST_LINES:
            raise csv.Error
        self.at += 1
        return self.lines[self.at - 1]


def rows_of(content: bytes) -> Iterator[TableRow | Broken]:
    """Rows with anything in them, the header first; raises `TableError`."""
    text = _text(content).replace("\r\n", "\n").replace("\r", "\n")
    delimiter, first = _told(text), 1
    if delimiter:  # the first line is no row
        text, first = text.partition("\n")[2], 2
    lines = _Lines([f"{line}\n" for line in text.split("\n")])
    found = csv.reader(lines, delimiter=delimiter or _delimiter(lines.lines), strict=True)
    count = 0
    while count <= MOST_ROWS:
        lines.start = lines.at
        line = lines.start + first
        made: TableRow | Broken
        try:
            cells = next(found)
        except StopIteration:
            return
        except csv.Error:
            lines.at = lines.start + 1
            reason = template("a quotation mark opens and does not close as it should")
            made = Broken(line, reason)
        else:
            stripped = tuple(cell.replace("\u00a0", " ").strip() for cell in cells)
            if not any(stripped):
                continue
            made = TableRow(line, stripped)
            if len(stripped) > MOST_COLUMNS:
                made = Broken(line, said("more than {most} columns", most=f"{MOST_COLUMNS:,}"))
        count += 1
        if count > MOST_ROWS:
            made = Broken(line, said("more than {most} rows: the rest was not read",
                                     most=f"{MOST_ROWS:,}"))  # fmt: skip
        yield made


def _text(content: bytes) -> str:
    if len(content) > MOST_BYTES:
        raise TableError("this file is too large to be a table of marks")
    if content[:4] in (b"PK\x03\x04", b"PK\x05\x06", b"\xd0\xcf\x11\xe0"):
        raise TableError(WORKBOOK)
    wide = content[:2] in (b"\xff\xfe", b"\xfe\xff")
    for read in [_UTF_16] if wide else [_UTF_8, of_a_spreadsheet]:
        try:
            text = read(content)
        except UnicodeDecodeError:
            continue
        if "\0" not in text:
            return text
    raise TableError("this is no file of text, so it is no table")


def _told(text: str) -> str:
    """The sign after `sep=` in a first line that Excel writes for itself; empty: there is none."""
    found = re.match(r'"?sep=([^\w\s"]|\t)"?[;,\t ]*\n', text, re.IGNORECASE)
    return found[1] if found else ""


def _delimiter(lines: Sequence[str]) -> str:
    """The one that splits the first rows as it splits the header; of several the one with most
    cells. A question may hold more commas than there are columns, and a title may stand above.
    """

    def fits(delimiter: str) -> tuple[int, int]:
        try:
            rows = list(islice(filter(None, csv.reader(lines[:MOST_LINES], delimiter=delimiter)),
                               LOOKED_AT))  # fmt: skip
        except csv.Error:
            return 0, 0
        cells = list(dropwhile(lambda count: count < 2, map(len, rows)))
        if not cells:
            return 0, 0
        return cells.count(cells[0]), cells[0]

    return max(DELIMITERS, key=fits)
