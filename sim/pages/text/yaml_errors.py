"""What is wrong with a YAML text, in words for somebody who has never heard of YAML."""

from __future__ import annotations

from collections.abc import Sequence


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
FOUND_TOO_LATE = ("could not find expected ':'", "expected ',' or '}'", "expected ',' or ']'")

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
        "the closing quote is missing",
        "begin and end a text with the same quote",
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
