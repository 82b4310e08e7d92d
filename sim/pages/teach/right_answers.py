"""Which answers of a choice are right, to be moved by fields: an answer that says nothing is wrong.

A value that stands in the text is changed in its place (edit.py). Here `correct` may have to be
written where nothing stands yet, and where one answer only is right, another loses it. The belief
behind an answer goes when it becomes right: a right answer has none, and no field holds it.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import Any

from sim.pages.teach.edit import CannotWriteError, Change, block_at, first_that_reads, read
from sim.pages.teach.spans import Value, names, values
from sim.pages.text.fence_scan import Block
from sim.pages.text.yaml.source import KeyPath


def may_be_right(block: Block) -> int:
    """How many answers of this block may be right or wrong; 0 where none is chosen or judged."""
    table = read(block) if block.name == "question" else None
    if not isinstance(table, Mapping):
        return 0
    options = table.get("options")
    judged = table.get("type") in ("single", "multiple")
    return len(options) if judged and isinstance(options, list) else 0


def is_rightness(path: KeyPath) -> bool:
    """Whether a field's path is that of an answer being right."""
    return len(path) == 3 and path[0] == "options" and path[2] == "correct"


def with_right(text: str, index: int, answer: int, *, right: bool) -> str:
    """The lesson's text with this answer of block number `index` right, or wrong.

    Of a single choice the answer that was right becomes a wrong one. Raises CannotWriteError.
    """
    block = block_at(text, index)
    if block is None or answer >= may_be_right(block):
        raise CannotWriteError("this value is no longer there")
    old = read(block)
    wanted = _flags(old)
    if right and old["type"] == "single":
        wanted = [False] * len(wanted)
    wanted[answer] = right
    return first_that_reads(
        text,
        index,
        _ways(text, block, _flags(old), wanted),
        lambda again: _rest(again, wanted) == _rest(old, wanted) and _flags(again) == wanted,
    )


def _ways(
    text: str, block: Block, old: Sequence[bool], wanted: Sequence[bool]
) -> Iterator[list[Change]]:
    """What to change; of an answer that says nothing yet, in each way in which it may be said."""
    at = {value.path: value for value in values(text, block)}
    changes: list[Change] = []
    new: list[Change] = []
    gone: list[list[Change]] = []
    for k in (k for k, flag in enumerate(wanted) if flag != old[k]):
        said = at.get(("options", k, "correct"))
        if said:
            changes.append((said.start, said.end, "true" if wanted[k] else "false"))
        else:
            new = list(_said_anew(text, block, k, at))
        if wanted[k]:
            gone += [[*_without(text, block, ("options", k, "belief"), at)]]
    added = [[one] for one in new] or [[]]
    removed = [list(one) for one in product(*filter(None, gone))]
    yield from ([*changes, *one, *other] for one in added for other in removed)


def _said_anew(text: str, block: Block, k: int, at: Mapping[KeyPath, Value]) -> Iterator[Change]:
    """Ways to write `correct: true` at an answer; the first that reads right is taken."""
    alone = at.get(("options", k))
    if alone:  # - They are equal.
        quoted = alone.style in ('"', "'")
        as_json = json.dumps(alone.value, ensure_ascii=False)
        words = text[alone.start : alone.end] if quoted else as_json
        yield alone.start, alone.end, f"{{text: {words}, correct: true}}"
    path = ("options", k, "text")
    key = next((name for name in names(text, block) if name.path == path), None)
    if key and path in at:
        end = at[path].end
        ends = "\r\n" if text[: text.find("\n", end) + 1].endswith("\r\n") else "\n"
        column = key.start - (text.rfind("\n", 0, key.start) + 1)
        yield end, end, ", correct: true"
        yield end, end, f"{ends}{' ' * column}correct: true"


def _without(
    text: str, block: Block, path: KeyPath, at: Mapping[KeyPath, Value]
) -> Iterator[Change]:
    """Ways to take a key out with its value: as one of its line's, or as a line of its own."""
    key = next((name for name in names(text, block) if name.path == path), None)
    if key is None or path not in at:
        return
    start, end = key.start, at[path].end
    if comma := re.search(r",\s*\Z", text[:start]):
        yield comma.start(), end, ""
    if comma := re.match(r"\s*,\s*", text[end:]):
        yield start, end + comma.end(), ""
    line_ends = text.find("\n", end) + 1
    yield text.rfind("\n", 0, start) + 1, line_ends, ""
    # The first of its answer stands behind a dash: the next takes its place.
    following = text[line_ends:]
    yield start, line_ends + len(following) - len(following.lstrip(" ")), ""


def _flags(table: Mapping[str, Any]) -> list[bool]:
    return [isinstance(o, Mapping) and o.get("correct") is True for o in table["options"]]


def _rest(table: Mapping[str, Any], wanted: Sequence[bool]) -> dict[str, Any]:
    """Everything but which answers are right, and the beliefs behind those that shall be."""
    plain = [o if isinstance(o, Mapping) else {"text": o} for o in table["options"]]
    bare = [
        {n: v for n, v in option.items() if n != "correct" and not (right and n == "belief")}
        for option, right in zip(plain, wanted, strict=True)
    ]
    return {**table, "options": bare}
