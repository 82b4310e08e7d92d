"""Mistakes in the text around the blocks: formulas, pictures, links, minutes.

The generator would show them, or say nothing: a picture without words is silent for who cannot see
it, a formula that is never closed prints its source, a lesson's minutes nobody adds up.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from urllib.parse import unquote

from yaml import YAMLError, safe_load

from sim.pages.effect_pages import EFFECTS, PLACE
from sim.pages.findings import Finding
from sim.pages.language import ENGLISH, UnknownLanguageError, language_of
from sim.pages.scene_block import Lesson
from sim.pages.text.fence_scan import KINDS, after_front_matter, meant_kind
from sim.pages.text.yaml_source import YamlError, load

_FENCE = re.compile(r"^[ \t>]*(`{3,}|~{3,})[ \t]*([^`\n]*)$", re.MULTILINE)
_INLINE_CODE = re.compile(r"(`+)(?!`).+?(?<!`)\1(?!`)")
_PICTURE = re.compile(r"!\[([^\]\n]*)\]\(([^)\s]*)[^)]*\)")
_LINK = re.compile(r"(?<!!)\[[^\]\n]+\]\(([^)\s]+)[^)]*\)")
_HTML_PICTURE = re.compile(r"<img\b(?![^>]*\balt=\"[^\"]+\")[^>]*>")
_FORMULA_MARK = re.compile(r"(?<!\\)\$\$|(?<!\\)\$|\\[()\[\]]")
_MINUTES = re.compile(r"^#{1,6} .*\bdata-minutes=\"?(\d+)\"?", re.MULTILINE)
_MORE = re.compile(r"\{.*\.more\b")  # a part for who has time: the lesson is whole without it
_OWN_MINUTES = re.compile(r"^[ \t]*minutes:[ \t]*(\d+)[ \t]*$", re.MULTILINE)
_AT_THE_TOP = r"\A---\s*\n(?:(?!---).*\n)*?"  # what may stand before a key of the front matter
_ORDER = re.compile(_AT_THE_TOP + r"order:[ \t]*([^\n#]*)")
_PLACE = re.compile(r"\d{1,4}")
_LANGUAGE = re.compile(_AT_THE_TOP + r"language:[ \t]*(\S[^\n#]*)")
_FEW = re.compile(rf"^[ \t]*(?<!`)`{{1,2}}({'|'.join(KINDS)})[ \t]*$", re.MULTILINE)
LAST = 1000  # lessons without a place of their own come behind those with one
_STATED = re.compile(_AT_THE_TOP + r"minutes:[ \t]*(\d+)[ \t]*\n")
_Found = tuple[int, str, str, str]  # place in the text, code, message, hint
_CLOSES = {"\\(": "\\)", "\\[": "\\]", "$": "$", "$$": "$$"}


def text_findings(text: str, lesson: Lesson) -> list[Finding]:
    """Everything that is wrong with the text of a lesson, apart from its blocks."""
    prose = without_code(text)
    found = [*_front_matter(text), *_few_backticks(prose)]
    found += [*_pictures(prose), *_formulas(prose), *_minutes(text, prose), *_language(text)]
    found += _minutes_of_questions(prose)
    if lesson.scene_folders:  # where the lesson lies is known
        found += _links(prose, lesson)
    return _located(found, text, lesson)


def language_findings(text: str, lesson: Lesson) -> list[Finding]:
    """What is wrong with `language:` in the front matter of a lesson."""
    return _located(_language(text), text, lesson)


def _located(found: Iterable[_Found], text: str, lesson: Lesson) -> list[Finding]:
    made = []
    for at, code, message, hint in found:
        line = text.count("\n", 0, at) + 1
        col = at - (text.rfind("\n", 0, at) + 1) + 1
        made.append(Finding(lesson.file, line, col, code, message, hint))
    return made


def lesson_order(path: Path) -> tuple[int, str]:
    """Where a lesson stands among the others: `order: 2` in its front matter, then its name."""
    with path.open(encoding="utf-8", errors="replace") as file:
        stated = _ORDER.match(file.read(2000))
    place = stated[1].strip() if stated else ""
    return int(place) if _PLACE.fullmatch(place) else LAST, path.name


def without_code(text: str) -> str:
    """The text with code blanked out, so that every place stays where it is. Our blocks stay."""
    kept = list(text)
    at = 0
    while opened := _FENCE.search(text, at):
        fence = re.escape(opened[1][0]) + "{" + str(len(opened[1])) + ",}"
        closing = re.compile(rf"^[ \t>]*{fence}[ \t]*$", re.MULTILINE)
        closed = closing.search(text, opened.end())
        end = closed.end() if closed else len(text)
        if not meant_kind(opened[2].strip().partition(" ")[0]):
            kept[opened.start() : end] = (
                c if c == "\n" else " " for c in text[opened.start() : end]
            )
        at = max(end, opened.end())
    return _INLINE_CODE.sub(lambda code: " " * len(code[0]), "".join(kept))


def _language(text: str) -> Iterator[_Found]:
    """A language that there are no interface words in."""
    stated = _LANGUAGE.match(text)
    try:
        language_of(stated[1].strip().strip("\"'") if stated else ENGLISH)
    except UnknownLanguageError as error:
        hint = "for example language: ms; without it the page speaks as the site does"
        yield stated.start(1) if stated else 0, "unknown-language", str(error), hint


def _front_matter(text: str) -> Iterator[_Found]:
    """Facts at the top that cannot be read: the page would print them and use none of them."""
    lines = text.splitlines(keepends=True)
    facts = "".join(lines[1 : max(1, after_front_matter(lines) - 1)])
    try:
        safe_load(facts)
    except YAMLError:
        try:
            load(facts, first_line=2)
        except YamlError as error:
            at = sum(map(len, lines[: error.line - 1])) + error.col - 1
            yield at, "yaml", error.message, error.hint
    if (stated := _ORDER.match(text)) and not _PLACE.fullmatch(stated[1].strip()):
        message = f"order: “{stated[1].strip()}” is not a whole number"
        yield stated.start(1), "not-a-number", message, "for example order: 30"


def _few_backticks(prose: str) -> Iterator[_Found]:
    """A block that begins with one or two backticks would be text, and swallow what follows."""
    hint = "write ``` here and at the end of the block"
    for opening in _FEW.finditer(prose):
        message = f"a block begins with three backticks: ```{opening[1]}"
        yield opening.start(), "few-backticks", message, hint


def _pictures(prose: str) -> Iterator[_Found]:
    hint = "say what it shows, without giving an answer away: ![two carts, one at rest](carts.png)"
    for picture in _PICTURE.finditer(prose):
        if not picture[1].strip():
            yield picture.start(), "missing-alt", "this picture has no words beside it", hint
    for picture in _HTML_PICTURE.finditer(prose):
        yield picture.start(), "missing-alt", "this picture has no words beside it", hint


def _formulas(prose: str) -> Iterator[_Found]:
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


def _minutes(text: str, prose: str) -> Iterator[_Found]:
    stated = _STATED.match(text)
    core = (m for m in _MINUTES.finditer(prose) if _MORE.search(m[0]) is None)
    parts = [int(m[1]) for m in core]
    if stated and parts and sum(parts) != int(stated[1]):
        message = f"the parts of this lesson take {sum(parts)} minutes, not {stated[1]}"
        hint = "change data-minutes of the headings, or minutes: above"
        yield stated.start(1), "minutes", message, hint


def _minutes_of_questions(prose: str) -> Iterator[_Found]:
    """Questions that take longer than the part of the lesson in which they stand."""
    parts = [*_MINUTES.finditer(prose)]
    ends = [part.start() for part in parts[1:]] + [len(prose)]
    for part, end in zip(parts, ends, strict=False):
        taken = sum(int(m[1]) for m in _OWN_MINUTES.finditer(prose, part.end(), end))
        if taken > int(part[1]):
            message = f"the questions of this part take {taken} minutes, the part only {part[1]}"
            yield part.start(), "minutes", message, "change one of them"


def _links(prose: str, lesson: Lesson) -> Iterator[_Found]:
    folder = lesson.scene_folders[0]
    for link in (*_LINK.finditer(prose), *_PICTURE.finditer(prose)):
        target = unquote(link[link.re.groups].split("#")[0].split("?")[0])
        if not target or re.match(r"[a-z][a-z0-9+.-]*:|//", target):
            continue
        if not any(place.exists() for place in _places(folder, target, lesson)):
            hint = "look at the name, and from which folder it is counted"
            yield link.start(), "broken-link", f"there is no file “{target[:60]}”", hint


def _places(folder: Path, target: str, lesson: Lesson) -> Iterator[Path]:
    """Where a link may lead: beside the lesson, or where the site puts lessons and pages."""
    source = re.sub(r"\.html$", ".md", target)
    yield folder / source
    yield folder / target
    depth = len(Path(lesson.file).parts) - 1
    root = folder.parents[depth - 1] if 0 < depth <= len(folder.parents) else folder
    inside = folder.relative_to(root).as_posix().removeprefix("docs").strip("/")
    address = os.path.normpath(f"{inside}/{source}").lstrip("/")
    yield root / address
    yield root / "docs" / address
    if lesson.file.startswith(EFFECTS):  # the pages of effects join the docs at their place
        yield from (root / "docs" / PLACE / source, folder.parent / Path(source).stem / "page.md")
    elif Path(address).parent.as_posix() == PLACE.strip("/"):
        yield root / EFFECTS / Path(source).stem / "page.md"
