"""What a word processor or a keyboard puts into a text and YAML silently takes for something else.

Looked for before the text is read, line by line, outside of text that goes on over lines (| and >).
"""

from __future__ import annotations

import re
from collections.abc import Iterator

INVISIBLE = "\u00a0\u00ad\u200b\u200c\u200d\u2007\u202f\u2060\ufeff"
"""Blanks that do not count as blanks, and characters that nobody sees."""

TEXTS = ("ask", "text", "title", "feedback", "explain", "start", "note", "says")
"""Keys whose values are prose, in which a # is meant as it stands, with a blank after it too."""

WORDS = (*TEXTS, "hints", "left", "right", "accept")
"""Where a number in typographic quotes may be what somebody says."""

CUT = "what comes after # is left out"
HINT_CUT = 'put the text in quotes: "Point #3"; a remark has a blank after its #'

_LEAD = re.compile(r"\s*(?:- +)*")
_KEY = re.compile(rf"\s*(?:- +)*[\w.-]*[{INVISIBLE}]|[^:#\"']*:[{INVISIBLE}]")
_NEVER = "\u00ad\u200b\u2060\ufeff"
"""Of these, what no language writes: a value that is no prose must not have it anywhere."""

_VALUE = re.compile(rf"\s*(?:- +)*([\w.-]+):\s[^\"'\[{{]*?([{_NEVER}])[^\"'\[{{]*$")
_WIDE = re.compile(r"\s*(?:- +)*[\w.-]+(：)|[^\"'#]*[{,]\s*[\w.-]+(：)")
_WIDE_COMMA = re.compile(r"[^\"'#]*\{[^\"'#]*?(，)\s*[\w.-]+:\s")
_CURLY = re.compile(
    "|".join(
        rf"\s*(?:- +)*[\w.-]+:\s+([{begins}])[^{ends}]*(?::\s|\s#)"
        rf"|[^\"'#]*[{{,]\s*[\w.-]+:\s+([{begins}])[^{ends}]*,"
        for begins, ends in (("“„", "”“"), ("«»「『", "»«」』"))
    )
)
"""Typographic quotes around what straight ones alone hold together: a colon; a comma in braces."""
_PAIR = {"“": "“ ”", "‘": "‘ ’", "„": "“ ”", "«": "« »", "»": "« »", "「": "「 」", "『": "『 』"}
_QUOTED_NUMBER = re.compile(
    r"(?:\s*(?:- +)*|[^\"'#]*[{,]\s*)(?P<key>(?!\d)[\w.-]+):\s+(?P<begins>[“„‘«])\s*"
    r"(?P<number>[-−+]?\d[^”“’»}]*?)\s*[”“’»]\s*(?:[,}].*)?"
)
"""A number that stands between typographic quotes, which would be part of it."""
_TIGHT = re.compile(r"\s*-(?=[{\[])")
_DASH = re.compile(r"\s*[–—][ \t]")
_LISTED = re.compile(r".*:\s*|\s*[-–—•·‣◦▪●○*−‐‑](?:[ \t].*|[^\W\d_].*)")
"""What stands above an entry of a list: its key, or another entry."""
_BULLET = re.compile(r"\s*([•·‣◦▪●○*−‐‑])[ \t]+(?=(.*))")
_TIGHT_WORD = re.compile(r"\s*-(?=([^\W\d_].*))")
_CUT = re.compile(rf"\s*(?:- +)*({'|'.join(TEXTS)}):\s+[^\s\"'|>{{\[#&*!].*?\s(#)")
_BLOCK = re.compile(r":\s*[|>][+-]?\d?\s*(?:#.*)?$|^\s*-\s+[|>][+-]?\d?\s*$")

Typo = tuple[int, int, str, str]
"""Line and column from 0, message and hint."""


def typos(text: str) -> Iterator[Typo]:
    """Every mistake of these kinds."""
    inside: int | None = None  # indentation of the key whose text goes on
    above = ""
    for number, line in enumerate(text.split("\n")):
        if not line.strip():
            continue
        indent = len(line) - len(line.lstrip(" "))
        if inside is not None and indent > inside:
            continue
        inside = indent if _BLOCK.search(line) else None
        yield from _in_line(number, line) if not _LISTED.fullmatch(above) else _entry(number, line)
        above = line


def _entry(number: int, line: str) -> Iterator[Typo]:
    """The same where an entry of a list may stand."""
    if found := _BULLET.match(line):
        message = f"“{found[1]}” begins no entry of a list"
        yield number, found.start(1), message, f"write - {found[2][:40]}"
    elif found := _TIGHT_WORD.match(line):
        hint = f"write - {found[1][:40]}"
        yield number, found.end() - 1, "a list entry begins with a hyphen and a space", hint
    else:
        yield from _in_line(number, line)


def _in_line(number: int, line: str) -> Iterator[Typo]:
    lead = _LEAD.match(line)
    if lead is not None and "\t" in lead[0]:
        at = lead[0].index("\t")
        yield number, at, "a tab character", "indent with spaces, two per step"
    elif found := _KEY.match(line):
        at = found.end() - 1
        yield number, at, *_unseen(line[at])
    elif (found := _VALUE.match(line)) and found[1] not in TEXTS:
        yield number, found.start(2), *_unseen(found[2])
    elif found := _WIDE.match(line):
        hint = "write “key: value”, with an ordinary colon and a space"
        yield number, found.start(found.lastindex or 1), "a wide colon (：) stands here", hint
    elif found := _WIDE_COMMA.match(line):
        yield number, found.start(1), "a wide comma (，) stands here", "write an ordinary comma: ,"
    elif (found := _QUOTED_NUMBER.fullmatch(line)) and found["key"] not in WORDS:
        message = f"the quotes ({_PAIR[found['begins']]}) would be part of this number"
        yield number, found.start("begins"), message, f"write {found['key']}: {found['number']}"
    elif found := _CURLY.match(line):
        quote = found.lastindex or 1
        message = f"typographic quotes ({_PAIR[found[quote]]}) hold no text together"
        yield number, found.start(quote), message, 'write straight quotes: "…"'
    elif found := _TIGHT.match(line):
        hint = "write a space after the hyphen: - {…}"
        yield number, found.end() - 1, "a list entry begins with a hyphen and a space", hint
    elif found := _DASH.match(line):
        hint = "a list begins with a hyphen and a space: - "
        yield number, found.end() - 2, "a long dash begins this line", hint
    elif found := _CUT.match(line):
        yield number, found.start(2), CUT, f'put the text in quotes: {found[1]}: "Point # 3"'


def _unseen(character: str) -> tuple[str, str]:
    message = f"a character that nobody sees (U+{ord(character):04X}) stands here"
    blank = character.isspace()
    return message, "delete it and type an ordinary space" if blank else "delete it"
