"""The units of Markdown around the blocks: headings, paragraphs, entries of lists, cells, titles.

Line by line, as an author writes: a paragraph is what stands together, its lines joined by a space.
What is no text (code, HTML, rules, addresses of links) is passed over and so stays as it is.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from sim.pages.translate.unit import Unit, is_prose

_HEADING = re.compile(r"(\s*#{1,6}\s+)(.*?)(?:\s+#+)?(?:\s*\{:?[^}]*\})?\s*")
_TITLED = re.compile(r"(\s*(?:!!!|\?\?\?\+?|===[!+]?)[^\"]*\")([^\"]*)\".*")
_NOTE = re.compile(r"\s*(?:!!!|\?\?\?\+?)\s.*")
_DELIMITERS = re.compile(r"\s*\|?\s*:?-+:?\s*(?:\|\s*:?-+:?\s*)*\|?\s*")
_BEGIN = re.compile(
    r"(\s*(?:>[ \t]?)*(?:(?:[-*+]|\d+[.)])[ \t]+|:[ \t]{2,3}|\[\^[^\]]+\]:[ \t]*)?)(.*)"
)
_RULE = re.compile(r"\s*(?:(?:[-*_][ \t]*){3,}|=+\s*|-{2,}\s*)")
_PASSED = re.compile(r"\s*(?:\{:[^}]*\}\s*|\[[^\]^][^\]]*\]:\s+\S.*|\*\[[^\]]+\]:.*)")
_FENCE = re.compile(r"[ \t>]*(`{3,}|~{3,})[^`]*")
_HTML = re.compile(r"\s*</?[a-zA-Z!]")
_CELL = re.compile(r"(?<!\\)\|")
_STEP = 4  # columns by which what belongs to a note or a list stands further right


@dataclass(slots=True)
class _Paragraph:
    """Lines that stand together: start and end of the text in each."""

    indent: str = ""
    where: str = "paragraph"
    parts: list[tuple[int, str]] = field(default_factory=list)

    def unit(self) -> Unit | None:
        """Lines joined; a line end that Markdown keeps stays one."""
        if not self.parts:
            return None
        text = ""
        for k, (_, part) in enumerate(self.parts):
            hard = part.endswith(("  ", "\\"))
            more = k < len(self.parts) - 1
            text += part.rstrip() + (("  \n" if part.endswith("  ") else "\n") if hard and more
                                     else " " if more else "")  # fmt: skip
        at, last = self.parts[-1]
        end = at + len(last.rstrip())
        return Unit(self.parts[0][0], end, text.strip(), "markdown", self.where, self.indent)


def markdown_units(lines: Sequence[str], starts: Sequence[int], begin: int) -> Iterator[Unit]:
    """The units of a run of `lines` without blocks of ours, from the line `begin` on.

    `starts`: where each line begins in the file.
    """
    tables = _table_lines(lines)
    paragraph, depth, k = _Paragraph(), 0, begin
    fresh = True  # behind an empty line: four columns more are code
    while k < len(lines):
        line, at = lines[k], starts[k]
        if k in tables or not line.strip() or _RULE.fullmatch(line) or _PASSED.fullmatch(line):
            yield from _given(paragraph)
            paragraph, fresh = _Paragraph(), not line.strip()
            yield from _cells(line, at) if tables.get(k) else ()
        elif fence := _FENCE.fullmatch(line):
            yield from _given(paragraph)
            paragraph, k = _Paragraph(), _closing(lines, k, fence[1])
        elif (heading := _HEADING.fullmatch(line)) or (heading := _TITLED.fullmatch(line)):
            yield from _given(paragraph)
            paragraph, fresh = _Paragraph(), True
            where = "heading" if "#" in heading[1] else "title of a note"
            found = Unit(at + heading.start(2), at + heading.end(2), heading[2], "markdown", where)
            yield from [found] if is_prose(found.text) else []
            depth = depth if where == "heading" else _columns(line) + _STEP
        elif _NOTE.fullmatch(line):
            depth = _columns(line) + _STEP
        elif fresh and (_HTML.match(line) or _columns(line) >= min(depth, _columns(line)) + _STEP):
            k = _over(lines, k)
        else:
            begun = _BEGIN.fullmatch(line)
            marker = begun[1] if begun else ""
            depth = min(depth, _columns(line) // _STEP * _STEP)
            if marker.strip(" \t>") or (fresh and not paragraph.parts):
                yield from _given(paragraph)
                blank = re.sub(r"[^\s>]", " ", marker)
                where = "entry of a list" if marker.strip(" \t>") else "paragraph"
                paragraph = _Paragraph(blank, where)
            if marker.strip(" \t>"):
                depth = _columns(line) + _STEP
            paragraph.parts.append((at + len(marker), line[len(marker) :]))
            fresh = False
        k += 1
    yield from _given(paragraph)


def _given(paragraph: _Paragraph) -> Iterator[Unit]:
    unit = paragraph.unit()
    if unit and is_prose(unit.text):
        yield unit


def _columns(line: str) -> int:
    return len(line) - len(line.lstrip(" "))


def _over(lines: Sequence[str], k: int) -> int:
    """The last line before the next empty one."""
    while k + 1 < len(lines) and lines[k + 1].strip():
        k += 1
    return k


def _closing(lines: Sequence[str], k: int, fence: str) -> int:
    closing = re.compile(rf"[ \t>]*{re.escape(fence[0])}{{{len(fence)},}}[ \t]*")
    ends = (j for j in range(k + 1, len(lines)) if closing.fullmatch(lines[j]))
    return next(ends, len(lines) - 1)


def _table_lines(lines: Sequence[str]) -> dict[int, bool]:
    """The lines of tables; false: the one between head and rows."""
    found: dict[int, bool] = {}
    for k, line in enumerate(lines):
        if k and "|" in line and _DELIMITERS.fullmatch(line) and "|" in lines[k - 1]:
            found |= {k - 1: True, k: False}
            found |= dict.fromkeys(range(k + 1, _over(lines, k) + 1), True)
    return found


def _cells(line: str, at: int) -> Iterator[Unit]:
    ends = [*(mark.start() for mark in _CELL.finditer(line)), len(line)]
    begin = 0
    for end in ends:
        cell = line[begin:end]
        text = cell.strip()
        start = at + begin + cell.find(text) if text else at
        if is_prose(text):
            yield Unit(start, start + len(text), text, "markdown", "cell of a table")
        begin = end + 1
