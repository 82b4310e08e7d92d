r"""What YAML takes out of a text without a word, found in the text as it was written.

In double quotes a backslash begins an escape: \frac is a form feed and “rac”, \theta a tab and
“heta”. Without quotes a text ends at “ #”. Both can be told only beside the nodes, which know where
each value stands and how it is quoted.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import yaml

from sim.pages.text.yaml_errors import BACKSLASH
from sim.pages.text.yaml_typos import CUT, HINT_CUT, Typo

_NEVER_MEANT = "0abtvfreNLP_"
"""Escapes for characters that no lesson has; TeX words begin like them, and `_` is written so."""

_OF_A_NEW_LINE = frozenset({
    "nabla", "natural", "ncong", "ne", "nearrow", "neg", "neq", "newline", "nexists", "ngeq",
    "nleq", "nless", "nmid", "nolimits", "nonumber", "normalsize", "not", "notag",
    "notin", "nparallel", "nprec", "nrightarrow", "nsim", "nsubseteq", "nsucc", "nu",
    "nwarrow",
})  # fmt: skip
"""TeX words that begin as a line break does: before any other word \\n is one, and may be meant."""

_ESCAPE = re.compile(r"\\(?:([A-Za-z]+)|.)", re.DOTALL)
_CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]")
_CUT = re.compile(r"[ \t]+(#)#*[^\s#]")


def lost(root: yaml.Node | None, text: str) -> Iterator[Typo]:
    """Every place of `text` where a part of a value goes missing; `root`: its nodes."""
    for node in _scalars(root):
        start, end = node.start_mark.index, node.end_mark.index
        if node.style == '"':
            at = _destroyed(text[start:end], node.value)
            if at is not None:
                yield *_place(text, start + at), *BACKSLASH
        elif node.style is None and (found := _CUT.match(text, end)):
            yield *_place(text, found.start(1)), CUT, HINT_CUT


def cut_above(lines: list[str], line: int) -> tuple[int, int, str, str] | None:
    """A “ #” that cut a text off at `line` or right above it: YAML did not understand the rest."""
    for number in (line, line - 1):
        here = lines[number] if 0 <= number < len(lines) else ""
        found = _CUT.search(here)
        if found and not set("\"'") & set(here[: found.start(1)]):
            return number, found.start(1), CUT, HINT_CUT
    return None


def _scalars(node: yaml.Node | None) -> Iterator[yaml.ScalarNode]:
    if isinstance(node, yaml.ScalarNode):
        yield node
    elif isinstance(node, yaml.SequenceNode):
        for item in node.value:
            yield from _scalars(item)
    elif isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            yield from _scalars(key)
            yield from _scalars(value)


def _destroyed(quoted: str, value: str) -> int | None:
    """Where the first backslash stands that YAML took and a formula needs; else 0 where the value
    has a character that no page can show."""
    for found in _ESCAPE.finditer(quoted):
        first = found[0][1]
        if first in _NEVER_MEANT or (first == "n" and found[1] in _OF_A_NEW_LINE):
            return found.start()
    return 0 if _CONTROL.search(value) else None


def _place(text: str, at: int) -> tuple[int, int]:
    """Line and column, from 0, of a place of the text."""
    return text.count("\n", 0, at), at - text.rfind("\n", 0, at) - 1
