"""Which answers of a choice are right, to be moved by fields: an answer that says nothing is wrong.

A value that stands in the text is changed in its place (edit.py). Here `correct` may have to be
written where nothing stands yet, and where one answer only is right, another loses it.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
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
        lambda again: _rest(again) == _rest(old) and _flags(again) == wanted,
    )


def _ways(
    text: str, block: Block, old: Sequence[bool], wanted: Sequence[bool]
) -> Iterator[list[Change]]:
    """What to change; of an answer that says nothing yet, in each way in which it may be said."""
    at = {value.path: value for value in values(text, block)}
    changes: list[Change] = []
    new: list[Change] = []
    for k in (k for k, flag in enumerate(wanted) if flag != old[k]):
        said = at.get(("options", k, "correct"))
        if said:
            changes.append((said.start, said.end, "true" if wanted[k] else "false"))
        else:
            new = list(_said_anew(text, block, k, at))
    yield from ([*changes, one] for one in new) if new else [changes]


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


def _flags(table: Mapping[str, Any]) -> list[bool]:
    return [isinstance(o, Mapping) and o.get("correct") is True for o in table["options"]]


def _rest(table: Mapping[str, Any]) -> dict[str, Any]:
    """Everything but which answers are right."""
    plain = [o if isinstance(o, Mapping) else {"text": o} for o in table["options"]]
    bare = [{name: v for name, v in option.items() if name != "correct"} for option in plain]
    return {**table, "options": bare}
