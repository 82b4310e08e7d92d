"""Slips of Markdown that the page would print as running text: a list or a table with no empty line
above it, a picture whose bracket is not closed, a formula of its own inside a sentence.

Other programs read some of these as they were meant. What is told here is what our Markdown makes
of them (`sim.pages.site.usual_settings`); each is a warning.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import groupby

from sim.pages.checks.list_slips import Line, list_slips
from sim.pages.findings import Finding
from sim.pages.text.fence_scan import after_front_matter, scan
from sim.pages.text.plain_lines import lines_of, without_code

Told = tuple[int, str, str, str]  # place in the text, code, message, hint
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_OWN = re.compile(  # a line of its own kind, with which nothing above it goes on
    r"[ \t]*(?:#{1,6}[ \t]|!!!|\?\?\?|<[a-zA-Z/!]|>|(?:-{2,}|={2,}|\*{3,}|_{3,})[ \t]*$)"
    r"|:[ \t]|\[\^[^\]\n]{1,60}\]:"
)
_DEFINED = re.compile(r":[ \t]|\[\^")  # a definition, a note: what is below it begins within it
_RAW = re.compile(
    r"<(pre|script|style|textarea|table|div)\b(?![^>]*\bmarkdown\b)[^>]*>.*?</\1>",
    re.DOTALL | re.IGNORECASE,
)
_HOLDS = re.compile(r"[ \t]*(?:[-*+][ \t]|\d+\.[ \t]|!!!|\?\?\?|:[ \t]|\[\^)")
_CODE = 4  # spaces
_FARTHEST = 400  # lines above one, in which that stands that holds it
_UNDER = re.compile(r":?-+:?")
_CELL_ENDS = re.compile(r"(?<!\\)\|")
_APART = re.compile(r"(!\[[^\W\d][^\]\n]{0,60}\])[ \t]+(\([^()\s]{1,60}\.\w{1,9}\))")
_NOT_CLOSED = re.compile(
    r"!\[[^\]\n]{0,200}\]\([^)\s]{1,200}(?=(?:[ \t][^)]{0,200}?)?(?:\n[ \t]*\n|\n?\Z))"
)
_OTHER_FORMULA = re.compile(
    r"(?<!\\)\\\[.{1,999}?\\\]|(?<![\\$])\$(?![$\s])(?:[^$\n]|\n(?!\n)){1,400}?\$", re.DOTALL
)
_FORMULA = re.compile(r"(?<!\\)\$\$(?:[^$\\]|\\.)+\$\$", re.DOTALL)
_BEFORE = re.compile(r"[ \t]*(?:(?:[-*+]|\d+\.)[ \t]+)?")


def markdown_slips(text: str, file: str) -> list[Finding]:
    """A warning for each, in the order of the lines."""
    plain = running_text(text)
    lists = plain
    for formula in (_FORMULA, _OTHER_FORMULA):  # a minus begins no list
        lists = formula.sub(lambda one: re.sub(r"\S", "x", one[0]), lists)
    pieces = [*_pieces(lists)]
    found = [*list_slips(pieces), *_pictures(plain)]
    found += [one for piece in pieces for one in _tables(piece)]
    found += [one for piece in _pieces(plain) for one in _formulas(piece)]
    made = []
    for at, code, message, hint in sorted(found):
        line, col = text.count("\n", 0, at) + 1, at - text.rfind("\n", 0, at)
        made.append(Finding(file, line, col, code, message, hint, "warning"))
    return made


def running_text(text: str) -> str:
    """The text without code, blocks, comments and the facts at its top, each place as it was."""
    lines = lines_of(without_code(text), keepends=True)
    gone = set(range(after_front_matter(lines)))
    for block in scan(lines):
        gone.update(range(block.start, block.end))
    kept = "".join(_blank(line) if k in gone else line for k, line in enumerate(lines))
    for ends, part in (("-->", _COMMENT), ("</", _RAW)):
        if ends in kept:
            kept = part.sub(lambda gone: _blank(gone[0]), kept)
    return kept


def _blank(text: str) -> str:
    return re.sub(r"[^\n]", " ", text)


def _pieces(text: str) -> Iterator[list[Line]]:
    """Lines that Markdown reads together: no empty line, heading, box or tag is between them. None
    where one of those but an empty line stands."""
    at, lines = 0, list[Line]()
    for one in text.split("\n"):
        lines.append(Line(at, one))
        at += len(one) + 1
    for (together, _), some in groupby(
        enumerate(lines), lambda one: (bool(one[1].text.strip()), bool(_OWN.match(one[1].text)))
    ):
        (first, line), *more = some
        if together:
            defined = line.indent >= _CODE and _DEFINED.match(lines[first - 1].text)
            own = defined or _OWN.match(line.text) or _is_code(lines, first)
            yield [] if own else [line, *(one for _, one in more)]


def _is_code(lines: Sequence[Line], at: int) -> bool:
    """Whether the line is indented as code is: nothing above it holds it."""
    room = lines[at].indent
    if room < _CODE:
        return False
    for line in reversed(lines[max(0, at - _FARTHEST) : at]):
        if line.text.strip() and line.indent < room:
            return not _HOLDS.match(line.text)
    return True


def _tables(piece: Sequence[Line]) -> Iterator[Told]:
    """Rows that make no table."""
    told = "this table would be printed with its bars"
    under = "below its first line write |---|---|, with a part for each of its columns"
    rows = [k for k, one in enumerate(piece) if _is_row(one.text.strip())]
    for k, one in enumerate(piece):
        if k and "|" in one.text and "|" in piece[k - 1].text and _is_under(one.text):
            if _cells(piece[k - 1].text) != _cells(one.text):
                yield piece[k - 1].start, "no-table", told, under
            elif k > 1:
                yield piece[k - 1].start, "no-table", told, "leave an empty line above it"
            return
    if len(rows) > 1 and rows[1] == rows[0] + 1:
        yield piece[rows[0]].start, "no-table", told, under


def _is_row(row: str) -> bool:
    return row[:1] == row[-1:] == "|" and bool(row.strip("|").strip())


def _is_under(row: str) -> bool:
    """Whether it is the line below the heads of a table."""
    return all(_UNDER.fullmatch(cell.strip()) for cell in _inside(row).split("|"))


def _cells(row: str) -> int:
    return len(_CELL_ENDS.findall(_inside(row))) + 1


def _inside(row: str) -> str:
    return row.strip().removeprefix("|").removesuffix("|")


def _formulas(piece: Sequence[Line]) -> Iterator[Told]:
    """Formulas for a paragraph of their own that have none."""
    text = "\n".join(line.text for line in piece)
    items = {line.at - piece[0].at for line in piece if line.item}
    for formula in _FORMULA.finditer(text):
        begins = text.rfind("\n", 0, formula.start()) + 1
        ends = text.find("\n", formula.end()) + 1 or len(text) + 1
        last = ends > len(text)
        alone = _BEFORE.fullmatch(text, begins, formula.start()) is not None
        alone = alone and not text[formula.end() : ends].strip()
        item = begins in items and (last or ends in items)
        if alone and (item or (begins == 0 and last)):
            continue
        message = "this formula stands in a sentence: its outer dollar signs would be printed"
        hint = "write $ … $, or leave an empty line above and below it"
        yield piece[0].at + formula.start(), "formula-in-text", message, hint


def _pictures(text: str) -> Iterator[Told]:
    told = "this would be printed, and no picture shown"
    for picture in _APART.finditer(text):
        hint = f"no space between the brackets: {picture[1]}{picture[2]}"
        yield picture.start(), "no-picture", told, hint
    for picture in _NOT_CLOSED.finditer(text):
        yield picture.start(), "no-picture", told, f"close the bracket: {picture[0][:80]})"
