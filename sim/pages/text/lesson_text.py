"""Mistakes in the text around the blocks: formulas, pictures, links, minutes.

The generator would show them, or say nothing: a picture without words is silent for who cannot see
it, a formula that is never closed prints its source, a lesson's minutes nobody adds up.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from sim.pages.blocks.scene_block import Lesson
from sim.pages.findings import Finding
from sim.pages.text.fence_scan import KINDS, after_front_matter
from sim.pages.text.films import is_film
from sim.pages.text.front_matter import Found, front_matter, language, stated_minutes
from sim.pages.text.held_back import empty_boxes, misspelt, no_box, without_scene, without_text
from sim.pages.text.links import PICTURE, links
from sim.pages.text.nameless import nameless
from sim.pages.text.plain_lines import lines_of, without_code
from sim.pages.text.raw_html import never_shown

MINUTES = "minutes"
_HTML_PICTURE = re.compile(r"<img\b(?![^>]*\balt=\"[^\"]+\")[^>]*>")
_FORMULA_MARK = re.compile(r"(?<!\\)\$\$|(?<!\\)\$|\\[()\[\]]")
_MINUTES = re.compile(r"^#{1,6} .*\bdata-minutes=\"?(\d+)\"?", re.MULTILINE)
_MORE = re.compile(r"\{.*\.more\b")  # a part for who has time: the lesson is whole without it
_OWN_MINUTES = re.compile(r"^[ \t]*minutes:[ \t]*(\d+)[ \t]*$", re.MULTILINE)
_FEW = re.compile(  # accents and quotes are what some keyboards and word processors put there
    rf"^[ \t]*(?<!`)(?:`{{1,2}}|(?!`{{3}})[`´ˋ'‘’‛]{{2,4}})[ \t]*({'|'.join(KINDS)})[ \t]*$",
    re.MULTILINE,
)
_OPEN_LIST = re.compile(r"^#{1,6} [^\n]*(\{:[^}\n]*)$", re.MULTILINE)
_NO_MINUTES = re.compile(
    r"^#{1,6} [^\n]*\bdata-minutes=(?!\"?\d+\"?(?:[ }]|$))([^}\s]*)", re.MULTILINE
)
_NEARLY_MINUTES = re.compile(
    r"^#{1,6} [^\n]*\{:[^}\n]*?((?!data-minutes=)\bdata-min\w*[ \t]*[=:][ \t]*\w*)", re.MULTILINE
)
_ROW = re.compile(r"^[ \t]*\|.*$", re.MULTILINE)
_ROW_FORMULA = re.compile(r"\\\((?:(?!\\\)).)*?(?<!\\)\|")
_CLOSES = {"\\(": "\\)", "\\[": "\\]", "$": "$", "$$": "$$"}


def text_findings(text: str, lesson: Lesson) -> list[Finding]:
    """Everything that is wrong with the text of a lesson, apart from its blocks."""
    prose = without_code(text)
    found = [*front_matter(text), *nameless(text), *_few_backticks(prose)]
    found += [*_pictures(prose), *_formulas(prose), *_minutes(text, prose), *language(text)]
    found += [*_headings(prose), *_formulas_in_rows(prose)]
    found += [*_minutes_of_questions(prose), *_held_back(prose, text), *never_shown(prose)]
    if lesson.scene_folders:  # where the lesson lies is known
        found += links(prose, lesson)
    return _located(found, text, lesson)


def minutes_last(found: Iterable[Finding], *, wrong: bool = False) -> list[Finding]:
    """Findings by place, minutes behind all others, and only where nothing else is `wrong`: a block
    with mistakes has none yet, and whoever mends it wants no sum."""
    listed = sorted(found)
    others = [one for one in listed if one.code != MINUTES]
    if wrong or any(one.severity == "error" for one in others):
        return others
    return [*others, *(one for one in listed if one.code == MINUTES)]


def language_findings(text: str, lesson: Lesson) -> list[Finding]:
    """What is wrong with `language:` in the front matter of a lesson."""
    return _located(language(text), text, lesson)


def _located(found: Iterable[Found], text: str, lesson: Lesson) -> list[Finding]:
    made = []
    for at, code, message, hint in found:
        line = text.count("\n", 0, at) + 1
        col = at - (text.rfind("\n", 0, at) + 1) + 1
        made.append(Finding(lesson.file, line, col, code, message, hint))
    return made


def _few_backticks(prose: str) -> Iterator[Found]:
    """A block that begins with too few backticks, or with other marks, would be printed as text."""
    hint = "write ``` here and at the end of the block"
    for opening in _FEW.finditer(prose):
        message = f"a block begins with three backticks: ```{opening[1]}"
        yield opening.start(), "few-backticks", message, hint


def _held_back(prose: str, text: str) -> Iterator[Found]:
    """Text that would wait, and is there at once; boxes that hold nothing."""
    for at in without_text(prose, text):
        message = "text below this “!!! after” does not belong to it, and is there at once"
        yield at, "nothing-held", message, "begin each line of what waits with four spaces"
    for at, kind in empty_boxes(prose, text):
        message = f"the box “{kind[:40]}” is empty: the text below does not belong to it"
        yield at, "empty-box", message, "begin each line of the box with four spaces"
    for at, should in no_box(prose, text):
        message = "this line opens no box: the page prints it, and what is in the box as code"
        yield at, "no-box", message, f"write {should[:80]}"
    hint = "put it below the scene whose run is watched first"
    for at, named in without_scene(prose):
        told = f"no scene “{named[:40]}” stands above it" if named else "no scene stands above it"
        yield at, "no-such-scene", f"“!!! after” waits for a run, and {told}", hint
    for at, word in misspelt(prose):
        message = f"“{word[:40]}” holds nothing back: this text is there at once"
        hint = "did you mean after?"
        if word == "after":  # the words behind it are read as kinds
            hint = "the title goes in straight quotes:"
        yield at, "unknown-word", message, f'{hint} !!! after "Title"'


def _pictures(prose: str) -> Iterator[Found]:
    hint = "say what it shows, without giving an answer away: ![two carts, one at rest](carts.png)"
    for picture in PICTURE.finditer(prose):
        if not picture[1].strip():
            kind = "film" if is_film(picture["wrapped"] or picture["bare"] or "") else "picture"
            yield picture.start(), "missing-alt", f"this {kind} has no words beside it", hint
    for picture in _HTML_PICTURE.finditer(prose):
        yield picture.start(), "missing-alt", "this picture has no words beside it", hint


def _formulas(prose: str) -> Iterator[Found]:
    """Formulas that are not closed in their paragraph, and brackets inside that do not match."""
    for paragraph in re.finditer(r"(?:[^\n]*\S[^\n]*\n?)+", prose):
        opened: re.Match[str] | None = None
        for mark in _FORMULA_MARK.finditer(paragraph[0]):
            if opened is None:
                opened = mark
                if mark[0] in ("\\)", "\\]"):
                    yield _at(paragraph, mark), *_open_formula(mark[0])
                    opened = None
            elif mark[0] == _CLOSES[opened[0]]:
                inside = paragraph[0][opened.end() : mark.start()]
                if not _braces_match(inside):
                    message = f"the braces in this formula do not match: {inside.strip()[:40]}"
                    hint = "every { needs its }"
                    yield _at(paragraph, opened), "unbalanced-formula", message, hint
                opened = None
        if opened is not None:
            yield _at(paragraph, opened), *_open_formula(opened[0])


def _formulas_in_rows(prose: str) -> Iterator[Found]:
    """A bar in a formula ends the cell of a table, and both halves are printed as they stand."""
    hint = r"write \lvert v \rvert, or \vert for a single bar"
    for row in _ROW.finditer(prose):
        for cut in _ROW_FORMULA.finditer(row[0]):
            at = row.start() + cut.end() - 1
            yield at, "unbalanced-formula", "a | in this formula ends the cell of the table", hint


def _headings(prose: str) -> Iterator[Found]:
    """Words for a heading that would be printed in it, or say nothing."""
    for heading in _OPEN_LIST.finditer(prose):
        message = "the closing } is missing behind this heading"
        yield heading.start(1), "open-heading", message, "## A part {: data-minutes=8 }"
    for heading in _NO_MINUTES.finditer(prose):
        message = f"data-minutes: “{heading[1][:20]}” is not a whole number"
        yield heading.start(1), "not-a-number", message, "for example {: data-minutes=8 }"
    for heading in _NEARLY_MINUTES.finditer(prose):
        message = f"“{heading[1][:30]}” does not say how long this part takes"
        yield heading.start(1), "unknown-word", message, "for example {: data-minutes=8 }"


def _at(paragraph: re.Match[str], mark: re.Match[str]) -> int:
    return paragraph.start() + mark.start()


def _open_formula(mark: str) -> tuple[str, str, str]:
    other = "the other end is missing in this paragraph"
    hint = r"write \( … \) or $ … $; for a dollar write \$"
    return "unbalanced-formula", f"a formula begins or ends with {mark} here, and {other}", hint


def _braces_match(formula: str) -> bool:
    depth = 0
    for brace in re.findall(r"(?<!\\)[{}]", formula):
        depth += 1 if brace == "{" else -1
        if depth < 0:
            return False
    return depth == 0


def _minutes(text: str, prose: str) -> Iterator[Found]:
    closed = after_front_matter(lines_of(text))
    stated = stated_minutes(text) if closed else None
    core = (m for m in _MINUTES.finditer(prose) if _MORE.search(m[0]) is None)
    parts = [int(m[1]) for m in core]
    if stated and parts and stated[1].isdecimal() and sum(parts) != int(stated[1]):
        message = f"the parts of this lesson take {sum(parts)} minutes, not {stated[1]}"
        hint = "change data-minutes of the headings, or minutes: above"
        yield stated[0], MINUTES, message, hint


def _minutes_of_questions(prose: str) -> Iterator[Found]:
    """Questions that take longer than the part of the lesson in which they stand."""
    parts = [*_MINUTES.finditer(prose)]
    ends = [part.start() for part in parts[1:]] + [len(prose)]
    for part, end in zip(parts, ends, strict=False):
        taken = sum(int(m[1]) for m in _OWN_MINUTES.finditer(prose, part.end(), end))
        if taken > int(part[1]):
            message = f"the questions of this part take {taken} minutes, the part only {part[1]}"
            yield part.start(), MINUTES, message, "change one of them"
