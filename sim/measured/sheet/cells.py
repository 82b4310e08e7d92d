"""A text of readings as rows of cells, and a cell as a number.

Programs disagree about everything: what stands between cells (tab, semicolon, comma, spaces), the
decimal sign, the minus sign, the end of a line, the first bytes of the file. All of it is found
out from the text; what could be read in two ways is refused with the line.
"""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache
from unicodedata import decimal

from sim.measured.refusal import refuse
from sim.measured.sheet.commas import MINUS, with_decimal_commas
from sim.measured.sheet.labelled import without_labels
from sim.measured.sheet.lying import stood_up
from sim.scene.encoded import of_a_spreadsheet
from sim.scene.said import said, template

MOST_BYTES = 4_000_000
"""Bytes of one file: an hour of a sensor at 20 readings per second, ten times over."""

_NO_TEXT = re.compile(rb"[\x00-\x08\x0e-\x1f\x7f]")  # signs of a picture or a program
MOST_LINES = 20_000
MOST_COLUMNS = 60
LONGEST_LINE = 10_000
LARGEST = 1e13
"""Nothing that a class measures is larger, in any of the units taken here; milliseconds since 1970
are a tenth of it."""

_MINUS = str.maketrans(dict.fromkeys(MINUS, "-"))
_NUMBER = re.compile(r"[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d{1,3})?", re.ASCII)
_OTHER_POINT = re.compile(r"(?<=\d)[．٫](?=\d)")
_DATED = re.compile(r"(\d[-/.]\d+[-/.]\d\d+),? +(?=\d+:\d+:)")
_BESIDE = re.compile(r", |[,.]\S*[,.]")
_NAMES = {
    "\t": template("tab"),
    ";": template("semicolon"),
    ",": template("comma"),
    "|": template("bar"),
    " ": template("space"),
}
_EMPTY = ("", "nan", "-nan", "null", "none", "n/a", "n.a.", "na", "#n/a", "#nv", "-", "--", "–",
          "—", "?")  # fmt: skip


@dataclass(frozen=True, slots=True)
class CellRow:
    """The cells of one line; `line` counts from 1, empty cells at the end are gone."""

    line: int
    cells: tuple[str, ...]

    @property
    def first(self) -> str:
        """What stands in the first cell; empty where there is none."""
        return self.cells[0] if self.cells else ""


@dataclass(frozen=True, slots=True)
class Rows:
    """All lines that hold something, with the separator that was found."""

    rows: tuple[CellRow, ...]
    separator: str

    @property
    def separator_name(self) -> str:
        """In words."""
        return _NAMES[self.separator]


def decoded(content: bytes) -> str:
    """The bytes as text: UTF-8 with or without its mark, UTF-16 with it; else, where no sign is in
    it that no text has, what spreadsheets of an older Windows write (windows-1252, GBK)."""
    if len(content) > MOST_BYTES:
        reason = said("this file is too large to be readings of two carts")
        raise refuse(1, reason, said("at most 4 MB"))
    coding = "utf-16" if content[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig"
    try:
        return content.decode(coding)
    except UnicodeDecodeError as error:
        with suppress(UnicodeDecodeError):
            if coding != "utf-16" and not _NO_TEXT.search(content):
                return of_a_spreadsheet(content)
        line = content[: error.start].count(b"\n") + 1
        reason = said("this is no text, or not in UTF-8")
        raise refuse(line, reason, said("save it as text (UTF-8)")) from None


def rows_of(text: str) -> Rows:
    """The text as rows of cells."""
    text = text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
    text = text if text.isascii() else with_our_digits(text)
    lines = _DATED.sub(r"\1T", text).split("\n")  # a date and its time are one cell
    if len(lines) > MOST_LINES:
        raise refuse(
            MOST_LINES + 1,
            said("more than {most} lines", most=f"{MOST_LINES:,}"),
            said("keep the seconds around the contact"),
        )
    for number, line in enumerate(lines, 1):
        if "\0" in line:
            hint = said("export the readings as text, for example CSV")
            raise refuse(number, said("this is no text"), hint)
        if len(line) > LONGEST_LINE:
            reason = said("this line has {count} characters", count=f"{len(line):,}")
            raise refuse(number, reason, said("is this the file?"))
    filled = [(k, line) for k, line in enumerate(lines, 1) if line.strip(" \t;,|\u00a0")]
    filled = without_labels(filled)
    if not filled:
        raise refuse(1, said("there is nothing in it"), said("choose the file with the readings"))
    separator = _separator([line for _, line in filled])
    cells = [_cells(k, line, separator) for k, line in filled]
    cells = with_decimal_commas(cells) if separator == "," else cells
    cells = _wide_apart(filled, cells) if separator == " " else cells
    if upright := stood_up(cells):
        return Rows(tuple(CellRow(filled[0][0], row) for row in upright), separator)
    rows = tuple(CellRow(k, row) for (k, _), row in zip(filled, cells, strict=True))
    for row in rows:
        if len(row.cells) > MOST_COLUMNS:
            reason = said(
                "{count} columns: at most {most} are read",
                count=f"{len(row.cells):,}",
                most=str(MOST_COLUMNS),
            )
            raise refuse(row.line, reason, said("export only t and x of the two carts"))
    return Rows(rows, separator)


def with_our_digits(text: str) -> str:
    """Numbers of other scripts, and of keyboards whose signs are twice as wide, as ours."""
    signs = {ord(c): str(decimal(c)) for c in set(text) if not c.isascii() and c.isdecimal()}
    return _OTHER_POINT.sub(".", text.translate(signs)) if signs else text


def _wide_apart(
    lines: Sequence[tuple[int, str]], cells: Sequence[tuple[str, ...]]
) -> list[tuple[str, ...]]:
    """Rows that two or more spaces part into as many cells as numbers have: heads like “t (s)”."""
    widths = [len(row) for row in cells if row and all(map(is_number, row))]
    usual = max(set(widths), key=widths.count, default=0)
    apart = [tuple(re.split(r"\s{2,}", line.strip())) for _, line in lines]
    return [
        wide if len(row) != usual == len(wide) > 1 else row
        for row, wide in zip(cells, apart, strict=True)
    ]


def _separator(lines: Sequence[str]) -> str:
    """What stands between cells, judged by the lines with digits in them."""
    judged = [line.strip(" ") for line in lines if any(c.isdigit() for c in line)][:200]
    judged = [line for line in judged if not line.lstrip().startswith("#")] or list(lines[:200])
    for sign in ("\t", ";", "|"):
        if 2 * sum(sign in line for line in judged) > len(judged):
            return sign
    with_comma = [line for line in judged if "," in line]
    if 2 * len(with_comma) > len(judged):
        # "0,1 0,2": spaces between numbers with decimal commas. "0.1, 0.2", "0.1,0.2 m": commas.
        spaced = [x for x in with_comma if x.split()[1:] and not _BESIDE.search(x)]
        quoted = any('"' in line for line in with_comma)
        return " " if 2 * len(spaced) > len(with_comma) and not quoted else ","
    return " "


def _cells(number: int, line: str, separator: str) -> tuple[str, ...]:
    if separator == " ":
        cells = line.split()
    elif '"' in line:
        try:
            cells = next(csv.reader([line], delimiter=separator, skipinitialspace=True), [])
        except csv.Error:
            reason = said("a quotation mark is never closed")
            raise refuse(number, reason, said("remove it")) from None
    else:
        cells = line.split(separator)
    kept = [cell.strip() for cell in cells]
    while kept and not kept[-1]:
        kept.pop()
    return tuple(kept)


def is_empty(cell: str) -> bool:
    """Whether a cell says that there is no reading."""
    return cell.lower() in _EMPTY


def is_number(cell: str) -> bool:
    """Whether a cell is a number in any of the ways they are written."""
    return _NUMBER.fullmatch(cell) is not None or _NUMBER.fullmatch(plain(cell)) is not None


def number_of(cell: str) -> float:
    """The number in a cell for which `is_number` holds; beyond LARGEST it is not finite."""
    value = float(plain(cell).replace(",", "."))
    return value if abs(value) <= LARGEST else math.inf


_THOUSANDS_APART = re.compile(
    r"[+-]?[1-9]\d{0,2}(?:(?:[ '’\u00a0\u2009\u202f]\d{3})+(?:[.,]\d*)?"
    r"|(?:,\d{3})+\.\d*|(?:\.\d{3})+,\d*)",
    re.ASCII,
)


def plain(cell: str) -> str:
    """The number without what parts its thousands, where that is certain: 1'850.2 or 1,850.2."""
    return cell if _NUMBER.fullmatch(cell) else _freed(cell)


@lru_cache(4096)  # words of heads, and signs for no reading: every reader asks them again
def _freed(cell: str) -> str:
    """The same for what is no plain number."""
    cell = cell.strip().translate(_MINUS)
    if _THOUSANDS_APART.fullmatch(cell) is None:
        return cell
    decimals = re.search(r"(?:[.,]\d*)?$", cell)
    assert decimals is not None
    return re.sub(r"[^\d+-]", "", cell[: decimals.start()]) + decimals[0]


def numbers(rows: Sequence[CellRow]) -> Iterator[tuple[int, str]]:
    """All cells that hold a number, with their lines; without what parts thousands."""
    return ((row.line, plain(cell)) for row in rows for cell in row.cells if is_number(cell))
