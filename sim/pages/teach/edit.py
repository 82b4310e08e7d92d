"""One value of a block takes the place of another; everything else stays as it is."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

from sim.pages.teach.pieces import blocks
from sim.pages.teach.spans import Value, values
from sim.pages.text.fence_scan import Block
from sim.pages.text.yaml.source import KeyPath, YamlError, load

Change = tuple[int, int, str]
"""Where a piece of the text begins and ends, and what takes its place."""

CANNOT = "this cannot be written in this field; write it in the text of the block"


class CannotWriteError(ValueError):
    """A value that cannot be put in its place; the message is for the teacher."""


def with_value(text: str, index: int, path: KeyPath, wanted: str) -> str:
    """The lesson's text with `wanted` as the value at `path` of its block number `index`.

    It is tried plain, then in quotes, until reading it again gives `wanted` there and the old
    values everywhere else. Raises CannotWriteError.
    """
    before = block_at(text, index)
    old = next((v for v in values(text, before) if v.path == path), None) if before else None
    plain = read(before) if before else None
    if before is None or old is None or plain is None:
        raise CannotWriteError("this value is no longer there")
    if old.value.rstrip("\n") == wanted.rstrip("\n"):
        return text
    line = text[old.start : text.find("\n", old.start) + 1]
    ways = _ways(old, wanted, "\r\n" if line.endswith("\r\n") else "\n")
    return first_that_reads(
        text,
        index,
        ([(old.start, old.end, way)] for way in ways),
        lambda again: _same(again, plain, path, wanted),
    )


def first_that_reads(
    text: str, index: int, ways: Iterable[Sequence[Change]], reads: Callable[[Any], bool]
) -> str:
    """The text changed in the first of these ways after which block number `index` reads as it
    should, and no block is more or fewer. Raises CannotWriteError if there is none."""
    for changes in ways:
        made = text
        for start, end, new in sorted(changes, reverse=True):
            made = made[:start] + new + made[end:]
        after = block_at(made, index)
        if after and len(blocks(made)) == len(blocks(text)):
            again = read(after)
            if again is not None and reads(again):
                return made
    raise CannotWriteError(CANNOT)


def block_at(text: str, index: int) -> Block | None:
    """Block number `index` of the lesson, if there is one."""
    found = blocks(text)
    return found[index] if 0 <= index < len(found) else None


def read(block: Block) -> Any:
    """What stands in a block, as plain values; None where it cannot be read."""
    try:
        return load(block.body).plain
    except YamlError:
        return None


def _ways(old: Value, wanted: str, line_end: str) -> Iterator[str]:
    """How `wanted` could be written, the way of the old value first."""
    lines = wanted.split("\n")
    quoted = {
        '"': json.dumps(wanted, ensure_ascii=False),
        "'": "'" + wanted.replace("'", "''") + "'",
    }
    if old.style in ("|", ">"):
        # In a folded text (>) an empty line stands for the end of a line.
        parted = [part for line in lines for part in (line, "")][:-1] if old.style == ">" else lines
        for head in (old.style, old.style + "-"):
            rows = [head, *(" " * old.indent + line if line else "" for line in parted)]
            yield line_end.join(rows)
    elif old.style in quoted and len(lines) == 1:
        yield quoted[old.style]
    if len(lines) == 1 and wanted == wanted.strip():
        yield wanted
    yield from quoted.values()
    yield _spelt_out(wanted)


def _spelt_out(text: str) -> str:
    r"""In double quotes, where \n in front of a u would be refused: it looks like TeX's \nu."""
    parts = (
        f"\\u{ord(part):04x}"
        if part in ("\n", "\t")
        else json.dumps(part, ensure_ascii=False)[1:-1]
        for part in re.split(r"([\n\t])", text)
    )
    return f'"{"".join(parts)}"'


def _same(new: Any, old: Any, path: KeyPath, wanted: str) -> bool:
    """Whether `new` is `old` with `wanted` at `path`."""
    if not path:
        if isinstance(new, bool):
            return wanted == str(new).lower()
        return isinstance(new, (str, int)) and str(new).rstrip("\n") == wanted.rstrip("\n")
    if type(new) is not type(old) or len(new) != len(old):
        return False
    if isinstance(old, list):
        return all(
            _same(new[k], old[k], path[1:], wanted) if k == path[0] else new[k] == old[k]
            for k in range(len(old))
        )
    return list(new) == list(old) and all(
        _same(new[k], old[k], path[1:], wanted) if k == path[0] else new[k] == old[k] for k in old
    )
