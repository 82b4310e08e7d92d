"""What is wrong with a YAML text, in words for somebody who has never heard of YAML."""

from __future__ import annotations

import re
from collections.abc import Sequence

from sim.pages.text.yaml.colons import no_colon
from sim.pages.text.yaml.dash import no_dash


class YamlError(ValueError):
    """What is wrong with a YAML text: line and column (from 1), message and hint.

    `others`: what else was found in the same reading.
    """

    def __init__(
        self, line: int, col: int, message: str, hint: str, others: Sequence[YamlError] = ()
    ) -> None:
        super().__init__(f"{line}:{col}: {message}")
        self.line = line
        self.col = col
        self.message = message
        self.hint = hint
        self.others = tuple(others)


# What PyYAML notices only on a later line; the line where it began is the one to mend.
NOT_HELD = ("expected ',' or '}'", "expected ',' or ']'")
FOUND_TOO_LATE = ("could not find expected ':'", *NOT_HELD)

BACKSLASH = (
    "a backslash means something else in double quotes",
    r"a formula goes in single quotes: 'How large is \(v\)?'",
)
NO_NEW_LINE = BACKSLASH[0], f"{BACKSLASH[1]}; a text with line breaks goes below ask: |"
HALF = "an escape for half a character, which no page can show", "type the character itself: 😀"
NOT_CLOSED = "the closing quote is missing", "begin and end a text with the same quote"
_VALUE = re.compile(r"\s*(?:- +)?[\w.-]+: +(?P<text>(?P<first>[*&>!%@`|\"'\[-]).*)")
"""A line `key: text` whose text begins with a sign that means something in YAML."""
_GOES_ON = re.compile(r"""("[^"]*"|'[^']*'|\[[^\]]*\])\s*[^\s#,]""")


def unclosed(lines: Sequence[str], last: int) -> tuple[int, int, str, str] | None:
    """Line and column (from 0), message and hint, of a double quote above line `last` that begins a
    text and that its line does not close."""
    for number, line in enumerate(lines[:last]):
        at = line.rfind('"')
        if line.replace('\\"', "").count('"') % 2 and line[:at].endswith((" ", "[", "{")):
            return number, at, *NOT_CLOSED
    return None


def of_first_sign(line: str, problem: str) -> tuple[int, str, str] | None:
    """Column (from 0), message and hint, if the text of `key: text` begins with a sign that cannot
    begin a text, goes on after the quote or bracket with which it began, or lacks a brace."""
    several = "mapping values" in problem or "expected <block end>" in problem
    if several and (told := _braces(line)):
        return told
    if "unknown escape character" in problem or "expected escape sequence" in problem:
        return line.index("\\"), *BACKSLASH
    found = _VALUE.match(line)
    if not found:
        return None
    first, at, text = found["first"], found.start("first"), found["text"].rstrip()
    if first not in "\"'[":
        return at, f"a text cannot begin with {first}", "put the whole text in quotes"
    if not _GOES_ON.match(text):
        return None
    if first == "'":
        hint = "with an apostrophe in it, the text goes in double quotes"
        return at, "the text goes on after a single quote", hint
    closing = "]" if first == "[" else first
    hint = f"put the whole text in single quotes: '{text[:40]}'"
    if first == '"' and "'" in text:
        hint = 'write “ ” inside the text, and " only around it'
    return at, f"the text goes on after the closing {closing}", hint


def of_neighbours(
    lines: Sequence[str], line: int, problem: str
) -> tuple[int, int, str, str] | None:
    """Line and column (from 0), message and hint, where another line is the one to mend."""
    return no_colon(lines, line, problem) or no_dash(lines, line)


def _braces(line: str) -> tuple[int, str, str] | None:
    """The same of a line with several keys, which braces hold together."""
    begins = re.match(r"\s*(?:- +)?[\w.-]+: *(\(?)", line)
    opened, closed = line.count("{"), line.count("}")
    if begins is None or "'" in line or '"' in line:
        return None
    if begins[1] and ":" in line[begins.end() :]:
        return begins.start(1), "round brackets hold no keys", "for example: {mass: 0.5 kg}"
    if closed > opened == 0:
        return begins.end(), "the opening { is missing", "for example: {mass: 0.5 kg}"
    return (line.rindex("}"), "a } too many", "every { needs one }") if closed > opened else None


# Part of what PyYAML says; the message and the hint that we give instead.
EXPLAINED = (
    (
        "mapping values are not allowed here",
        "a colon where none is expected",
        "one “key: value” on a line; text with a colon in it goes in quotes",
    ),
    (
        "could not find expected ':'",
        "a colon is missing",
        "write “key: value”, with a space after the colon",
    ),
    (
        "but got '?'",
        "a question mark inside { } or [ ]",
        'put the text in quotes: {ask: "What happens?"}',
    ),
    (
        "expected ',' or '}'",
        "a comma or the closing } is missing",
        "for example: {mass: 0.5 kg, position: 0.4 m}; a text with a colon or a comma in it goes "
        "in quotes",
    ),
    (
        "expected ',' or ']'",
        "a comma or the closing ] is missing",
        "for example: [x, v, F]",
    ),
    (
        "while scanning a quoted scalar",
        *NOT_CLOSED,
    ),
    (
        "expected a single document",
        "a line of --- begins a second text",
        "keep only the first",
    ),
    (
        "expected <block end>",
        "this line is not indented like its neighbours",
        "lines that belong together begin in the same column",
    ),
    (
        "unindent does not match",
        "this line is not indented like its neighbours",
        "lines that belong together begin in the same column",
    ),
    (
        "cannot start any token",
        "this character cannot begin a value",
        "put the text in quotes",
    ),
)
