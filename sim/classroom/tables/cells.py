"""A file as rows of cells: CSV with commas, semicolons or tabs, in any usual encoding.

Nothing is evaluated: a cell is text. A row that is broken is named by its line, the others stay.
"""

from __future__ import annotations

import csv
from collections.abc import Iterator
from dataclasses import dataclass

from sim.scene.said import said, template

MOST_BYTES = 50_000_000
MOST_ROWS = 200_000
MOST_COLUMNS = 1_000

DELIMITERS = (",", ";", "\t")
WORKBOOK = template(
    "this is a workbook or a zip, not a table of text: open it and save it as CSV "
    "(File, Save as, CSV UTF-8)"
)


class TableError(ValueError):
    """This is no table of marks, or no mark; the message is for the teacher."""


@dataclass(frozen=True, slots=True)
class Row:
    """Cells without spaces around them, and the line of the file where they begin."""

    line: int
    cells: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Broken:
    """A row that cannot be split into cells."""

    line: int
    reason: str


def rows_of(content: bytes) -> Iterator[Row | Broken]:
    """Rows with anything in them, the header first; raises `TableError`."""
    text = _text(content)
    start = 1
    if text[:4].lower() == "sep=":  # what Excel writes for itself
        text = text.partition("\n")[2]
        start = 2
    lines = text.splitlines(keepends=True)
    found = csv.reader(lines, delimiter=_delimiter(text), strict=True)
    count = 0
    while True:
        line = found.line_num + start
        try:
            cells = next(found)
        except StopIteration:
            return
        except csv.Error:
            yield Broken(line, template("a quotation mark opens and does not close as it should"))
            continue
        stripped = tuple(cell.replace("\u00a0", " ").strip() for cell in cells)
        if not any(stripped):
            continue
        count += 1
        if count > MOST_ROWS:
            yield Broken(line, said("more than {most} rows: the rest was not read",
                                    most=f"{MOST_ROWS:,}"))  # fmt: skip
            return
        if len(stripped) > MOST_COLUMNS:
            yield Broken(line, said("more than {most} columns", most=f"{MOST_COLUMNS:,}"))
        else:
            yield Row(line, stripped)


def _text(content: bytes) -> str:
    if len(content) > MOST_BYTES:
        raise TableError("this file is too large to be a table of marks")
    if content[:4] in (b"PK\x03\x04", b"PK\x05\x06", b"\xd0\xcf\x11\xe0"):
        raise TableError(WORKBOOK)
    wide = content[:2] in (b"\xff\xfe", b"\xfe\xff")
    for encoding in ["utf-16"] if wide else ["utf-8-sig", "cp1252"]:
        try:
            text = content.decode(encoding)
        except UnicodeDecodeError:
            continue
        if "\0" not in text:
            return text
    raise TableError("this is no file of text, so it is no table")


def _delimiter(text: str) -> str:
    """The one that splits the header into most cells."""
    head = text.lstrip("\r\n").partition("\n")[0]

    def cells(delimiter: str) -> int:
        try:
            return len(next(csv.reader([head], delimiter=delimiter), []))
        except csv.Error:
            return 0

    return max(DELIMITERS, key=cells)
