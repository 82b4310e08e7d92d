r"""What YAML takes out of a text without a word, found in the text as it was written.

In double quotes a backslash begins an escape: \frac is a form feed and “rac”, \theta a tab and
“heta”. Without quotes a text ends at “ #”. Both can be told only beside the nodes, which know where
each value stands and how it is quoted.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import yaml

from sim.lesson.units import dimension_of
from sim.pages.text.yaml.errors import BACKSLASH, HALF, NO_NEW_LINE
from sim.pages.text.yaml.typos import CUT, HINT_CUT, Typo
from sim.scene.quantity import QuantityError, read_quantity, unit_of

PROSE_KEYS = frozenset({
    "accept", "ask", "between", "choice", "columns", "contact", "description", "distance",
    "explain", "feedback", "focus", "hints", "intro", "left", "note", "objects", "options",
    "order", "others", "plot", "right", "rows", "rubric", "start", "text", "title", "words",
})  # fmt: skip
"""Keys that hold free text, itself or in a list: those with `sim.scene.prose.MARK` in a schema."""

_NEVER_MEANT = "0abtvfreNLP_"
"""Escapes for characters that no lesson has; TeX words begin like them, and `_` is written so."""

_OF_A_NEW_LINE = frozenset({
    "nabla", "ncong", "nearrow", "neq", "ngeq", "nleq", "nolimits", "nonumber", "notag", "notin",
    "nprec", "nrightarrow", "nsubseteq", "nsucc", "nwarrow",
})  # fmt: skip
"""TeX words that begin as a line break does: before any other word \\n is one, and may be meant."""

_IN_A_FORMULA = _OF_A_NEW_LINE | {
    "natural", "ne", "neg", "newline", "nexists", "nless", "nmid", "normalsize", "not", "nparallel",
    "nsim", "nu",
}  # fmt: skip
"""Those too whose rest may begin a line of words: more or\\nless."""

_FORMULA = re.compile(r"\$(?!\s)[^$]+(?<!\s)\$(?!\d)|\\\\\(.*?\\\\\)|\\\\\[.*?\\\\\]", re.DOTALL)
"""In double quotes as they are written: $…$, \\\\(…\\\\), \\\\[…\\\\]."""

_ESCAPE = re.compile(r"\\(?:([A-Za-z]+)|.)", re.DOTALL)
_CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]")
_HALF = re.compile("[\ud800-\udfff\ufffe\uffff]")
_WRITTEN_HALF = re.compile(r"\\(?:\\|u(?:0000)?(?:d[89a-f]|fff[ef]))", re.IGNORECASE)
CUT_OFF = re.compile(r"[ \t]+(#)#*[^\s#]")


def lost(root: yaml.Node | None, text: str) -> Iterator[Typo]:
    """Every place of `text` where a part of a value goes missing; `root`: its nodes."""
    for node, prose in _scalars(root, prose=False):
        start, end = node.start_mark.index, node.end_mark.index
        if node.style == '"':
            if found := _destroyed(text[start:end], node.value):
                at, message, hint = found
                yield *place_of(text, start + at), message, hint
        elif prose and (cut := CUT_OFF.match(text, end)) and _is_text(node):
            yield *place_of(text, cut.start(1)), CUT, HINT_CUT


def _scalars(node: yaml.Node | None, *, prose: bool) -> Iterator[tuple[yaml.ScalarNode, bool]]:
    """Every single value, and whether free text may stand there."""
    if isinstance(node, yaml.ScalarNode):
        yield node, prose
    elif isinstance(node, yaml.SequenceNode):
        for item in node.value:
            yield from _scalars(item, prose=prose)
    elif isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            name = str(key.value)
            yield from _scalars(key, prose=False)
            yield from _scalars(value, prose=name in PROSE_KEYS or (prose and name.isdecimal()))


def _is_text(node: yaml.ScalarNode) -> bool:
    """Words without quotes; no text goes on behind nothing, true, false, a number, a quantity."""
    words = node.style is None and node.tag.endswith(":str")
    return words and not is_quantity(str(node.value))


def is_quantity(text: str) -> bool:
    """A number, with a unit or without."""
    dimension = dimension_of(unit_of(text))
    if dimension is None:
        return False
    try:
        read_quantity(text, dimension)
    except QuantityError:
        return False
    return True


def _destroyed(quoted: str, value: str) -> tuple[int, str, str] | None:
    """Where the first backslash stands that YAML took and a formula needs, with what is said to it;
    else 0 where the value has a character that no page can show."""
    formulas = [found.span() for found in _FORMULA.finditer(quoted)]
    for found in _ESCAPE.finditer(quoted):
        at, first = found.start(), found[0][1]
        if first in _NEVER_MEANT:
            return at, *BACKSLASH
        inside = any(start < at < end for start, end in formulas)
        if found[1] in (_IN_A_FORMULA if inside else _OF_A_NEW_LINE):
            return at, *NO_NEW_LINE
    if _HALF.search(value):
        halves = (one.start() for one in _WRITTEN_HALF.finditer(quoted) if one[0] != "\\\\")
        return next(halves, 0), *HALF
    return (0, *BACKSLASH) if _CONTROL.search(value) else None


def place_of(text: str, at: int) -> tuple[int, int]:
    """Line and column, from 0, of a place of the text."""
    return text.count("\n", 0, at), at - text.rfind("\n", 0, at) - 1
