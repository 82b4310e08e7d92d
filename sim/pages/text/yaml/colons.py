"""The line that lacks a colon, or the space behind it: YAML breaks off at the next one."""

from __future__ import annotations

import re
from collections.abc import Sequence

_GLUED = re.compile(r"(\s*(?:- +)?)([\w.-]+):(?![\s/])\S")
"""`key:text`, which is one word; but no address, as in https://."""
_BARE = re.compile(r"(?P<indent> *)(?P<dash>- +)?(?P<key>[\w.-]+)(?P<text>(?: +[^:#\s][^:#]*)?)")
"""`key text`, or `key` alone: a line without a colon that may be meant to have one."""


def no_colon(lines: Sequence[str], line: int, problem: str) -> tuple[int, int, str, str] | None:
    """Line and column (from 0), message and hint, where the line above has no colon, or no space
    behind it: then it is a text, and the colon of this line is one too many."""
    if "mapping values are not allowed" not in problem or line < 1:
        return None
    above = lines[line - 1]
    if found := _GLUED.match(above):
        told = f"{found[2]}: {above[found.end(2) + 1 :].strip()[:40]}"
        return line - 1, found.end(2), "a space is missing behind this colon", f"write {told}"
    bare = _BARE.fullmatch(above.rstrip())
    if not bare or not _begins(lines, line, bare):
        return None
    told = f"{bare['key']}: {bare['text'].strip()[:40]}".rstrip()
    return line - 1, bare.end("key"), "a colon is missing", f"write {told}"


def _begins(lines: Sequence[str], line: int, bare: re.Match[str]) -> bool:
    """Whether the line above `line` is the first of its table, in which this line stands too; a
    text that goes on over several lines is none."""
    column = bare.start("key")
    if len(lines[line]) - len(lines[line].lstrip(" ")) != column:
        return False
    if bare["dash"]:
        return True
    before = next((one for one in reversed(lines[: line - 1]) if one.strip()), "")
    return not before.strip() or before.rstrip().endswith(":")
