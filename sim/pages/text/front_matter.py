"""The facts at the top of a lesson, between two lines of ---: what is wrong with them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from difflib import get_close_matches
from pathlib import Path

from yaml import YAMLError, safe_load

from sim.pages.language import ENGLISH, UnknownLanguageError, language_of
from sim.pages.text.fence_scan import after_front_matter
from sim.pages.text.plain_lines import lines_of
from sim.pages.text.yaml.source import YamlError, load

KEYS = (
    *("title", "description", "author", "minutes", "order", "language"),
    *("hide", "search", "tags", "template", "icon", "status", "date", "robots", "subtitle"),
)
"""Ours, the generator's and its theme's. Others are the author's own."""
NEAR = 0.75  # of the letters in their order: “descripton” and “titel”, but no other word

AT_THE_TOP = (
    r"\A\ufeff?---\s*\n(?:(?!---).*\n)*?"  # what may stand before a key of the front matter
)
_ORDER = re.compile(AT_THE_TOP + r"order:[ \t]*([^\n#]*)")
_LONG = re.compile(AT_THE_TOP + r"minutes:[ \t]*([^\n#]*)")
_PLACE = re.compile(r"\d{1,4}")
_LANGUAGE = re.compile(AT_THE_TOP + r"language:[ \t]*(\S[^\n#]*)")
_KEY = re.compile(r"([^\W\d][\w-]*)[ \t]*:(?:\s|$)")
_NEARLY_BEGUN = re.compile(
    r"\ufeff?(?P<blank>[ \t]*\n)*(?P<dashes>[ \t]*[-–—―_]+)[ \t]*\n"
    rf"(?:{'|'.join(KEYS)})[ \t]*:"
)
LAST = 1000  # lessons without a place of their own come behind those with one
Found = tuple[int, str, str, str]  # place in the text, code, message, hint


def lesson_order(path: Path) -> tuple[int, str]:
    """Where a lesson stands among the others: `order: 2` in its front matter, then its name."""
    with path.open(encoding="utf-8-sig", errors="replace") as file:
        stated = _ORDER.match(file.read(2000))
    place = stated[1].strip() if stated else ""
    return int(place) if _PLACE.fullmatch(place) else LAST, path.name


def stated_language(text: str) -> str:
    """What a lesson says at its top that it speaks; "" where it says nothing."""
    stated = _LANGUAGE.match(text)
    return stated[1].strip().strip("\"'") if stated else ""


def stated_minutes(text: str) -> tuple[int, str] | None:
    """Where a lesson says at its top how long it takes, and what stands there, without quotes."""
    stated = _LONG.match(text)
    return (stated.start(1), stated[1].strip().strip("\"'")) if stated else None


def language(text: str) -> Iterator[Found]:
    """A language that there are no interface words in."""
    stated = _LANGUAGE.match(text)
    try:
        language_of(stated_language(text) if stated else ENGLISH)
    except UnknownLanguageError as error:
        hint = "for example language: ms; without it the page speaks as the site does"
        yield stated.start(1) if stated else 0, "unknown-language", str(error), hint


def front_matter(text: str) -> Iterator[Found]:
    """Facts at the top that cannot be read: the page would print them and use none of them."""
    lines = lines_of(text, keepends=True)
    inside = lines[1 : max(1, after_front_matter(lines) - 1)]
    if (
        not inside
        and lines
        and lines[0].strip("\ufeff \r\n") == "---"
        and _KEY.match("".join(lines[1:2]))
    ):
        hint = "write --- in a line of its own below them"
        yield 0, "yaml", "the lines at the top are not closed: the page would print them", hint
    if not inside and (found := _NEARLY_BEGUN.match(text)) and _is_no_beginning(found):
        hint = "the very first line of the file is --- (three hyphens), as is the line below them"
        message = "the lines at the top do not begin with ---: the page would print them"
        yield found.start("dashes"), "yaml", message, hint
    facts = "".join(inside)
    try:
        safe_load(facts)
    except YAMLError:
        try:
            load(facts, first_line=2)
        except YamlError as error:
            at = sum(map(len, lines[: error.line - 1])) + error.col - 1
            yield at, "yaml", error.message, error.hint
    except ValueError:  # its own words differ from one Python to the next
        hint = "for example date: 2026-11-30; a text that only looks like a date stands in quotes"
        yield _no_value(lines, 1 + len(inside)), "yaml", "no calendar has this day", hint
    stated = _ORDER.match(text) if inside else None
    if stated and not _PLACE.fullmatch(stated[1].strip()):
        message = f"order: “{stated[1].strip()}” is not a whole number"
        yield stated.start(1), "not-a-number", message, "for example order: 30"
    long = stated_minutes(text) if inside else None
    if long and not _PLACE.fullmatch(long[1]):
        message = f"minutes: “{long[1][:20]}” is not a whole number"
        yield long[0], "not-a-number", message, "for example minutes: 45"
    yield from _misspelt(inside, len(lines[0]) if lines else 0)


def _no_value(lines: Sequence[str], end: int) -> int:
    """Where the first line stands whose value is none: the lines above it can be read."""

    def readable(count: int) -> bool:
        try:
            safe_load("".join(lines[1 : 1 + count]))
        except YAMLError:  # a list, say, that goes on in the next line
            return True
        except ValueError:
            return False
        return True

    first = next((n for n in range(1, end) if not readable(n)), 1)
    return sum(map(len, lines[:first]))


def _is_no_beginning(found: re.Match[str]) -> bool:
    """Blank lines above the hyphens, or a dash in their place, as word processors make of them."""
    return found["blank"] is not None or found["dashes"] != "---"


def _misspelt(lines: Sequence[str], at: int) -> Iterator[Found]:
    """Names that are nearly one of ours: nothing would read them, and nobody would say so."""
    for line in lines:
        name = found[1] if (found := _KEY.match(line)) else ""
        meant = get_close_matches(name.lower(), KEYS, 1, NEAR) if name and name not in KEYS else []
        if meant:
            yield at, "unknown-key", f"“{name[:40]}” is no key at the top of a page", f"{meant[0]}:"
        at += len(line)
