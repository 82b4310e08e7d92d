"""Finds the fenced blocks of a lesson in its raw text, with the lines they stand on.

Markdown extensions neither keep line numbers nor report a block that they do not understand, so
the lesson is scanned before Markdown sees it. The rules are CommonMark's: a fence of three or more
backticks or tildes, closed by at least as many of the same; what stands inside a longer fence is
an example, not a block. A block may stand in a list or a note, indented by spaces.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from difflib import get_close_matches

KINDS = (
    *(
        "scene",
        "map",
        "cost",
        "hard-cases",
        "question",
        "quiz",
        "challenge",
        "evidence",
        "measured",
        "law",
        "picture",
    ),
)

_OPEN = re.compile(
    r"(?P<indent>[ \t]*)(?P<quote>(?:>[ \t]?)*)(?P<fence>`{3,}|~{3,})[ \t]*(?P<info>[^`]*)"
)
_ID = re.compile(r"^id:[ \t]*[\"']?([a-z0-9-]+)", re.MULTILINE)
_FRONT_MATTER = re.compile(r"\ufeff?---[ \t]*")  # teacher mode keeps all bytes of a file
_FRONT_MATTER_END = re.compile(r"(---|\.\.\.)[ \t]*")
# Names of programming languages that look like ours and are meant as written.
_LANGUAGES = frozenset({"scheme", "scss", "sql"})


@dataclass(frozen=True, slots=True)
class Block:
    """One fenced block of ours: lines are indices into the scanned lines, `end` is exclusive.

    `name` is what the author wrote after the backticks, `rest` what follows it. `body` has the
    block's indentation removed; `body_indent` says how many columns that were.
    """

    name: str
    rest: str
    start: int
    end: int
    indent: str
    body: str
    body_indent: int
    closed: bool
    fault: str = ""

    @property
    def stated_id(self) -> str:
        """The id that its text states, also where the rest of it cannot be read; empty: none."""
        found = _ID.search(self.body)
        return found[1] if found else ""


def scan(lines: Sequence[str], *, front_matter: bool = True) -> Iterator[Block]:
    """Every block of ours, and those whose name comes close to one of ours."""
    return (one for one in fenced(lines, front_matter=front_matter) if meant_kind(one.name))


def fenced(lines: Sequence[str], *, front_matter: bool = True) -> Iterator[Block]:
    """Every fenced block, whatever it is called."""
    index = after_front_matter(lines) if front_matter else 0
    while index < len(lines):
        opened = _OPEN.fullmatch(lines[index].rstrip("\r\n"))
        if opened is None:
            index += 1
            continue
        end, closed = _closing(lines, index, opened["fence"])
        name, _, rest = opened["info"].strip().partition(" ")
        yield _block(lines, index, end, closed, opened, name, rest.strip())
        index = end


def with_swallowed(block: Block) -> Iterator[Block]:
    """The block, and those that stand in its text, for want of its closing line."""
    yield block
    yield from scan(block.body.split("\n"), front_matter=False)


def meant_kind(name: str) -> str | None:
    """The kind of block that `name` is or was most likely meant to be; None for anything else."""
    plain = name.strip("{}.:").lower()
    if plain in KINDS:
        return plain
    if plain in _LANGUAGES or len(plain) < 4:
        return None
    near = get_close_matches(plain, KINDS, n=1, cutoff=0.78)
    return near[0] if near else None


def after_front_matter(lines: Sequence[str]) -> int:
    """Index of the first line behind the front matter; 0 where there is none."""
    if not lines or not _FRONT_MATTER.fullmatch(lines[0].rstrip("\r\n")):
        return 0
    for index, line in enumerate(lines[1:], start=1):
        if _FRONT_MATTER_END.fullmatch(line.rstrip("\r\n")):
            return index + 1
    return 0  # never closed: then it was a line, not front matter


def _closing(lines: Sequence[str], start: int, fence: str) -> tuple[int, bool]:
    """Index after the closing line, and whether there is one."""
    closing = re.compile(rf"[ \t]*(?:>[ \t]?)*{re.escape(fence[0])}{{{len(fence)},}}[ \t]*")
    for index in range(start + 1, len(lines)):
        if closing.fullmatch(lines[index].rstrip("\r\n")):
            return index + 1, True
    return len(lines), False


def _block(
    lines: Sequence[str],
    start: int,
    end: int,
    closed: bool,
    opened: re.Match[str],
    name: str,
    rest: str,
) -> Block:
    indent = opened["indent"]
    raw = [line.rstrip("\r\n") for line in lines[start + 1 : end - 1 if closed else end]]
    fault = ""
    if opened["quote"]:
        fault = "in-quote"
    elif "\t" in indent:
        fault = "tab-indent"
    elif any(line.strip() and not line.startswith(indent) for line in raw):
        fault = "less-indented"
    body = "\n".join(line[len(indent) :] for line in raw)
    return Block(name, rest, start, end, indent, body, len(indent), closed, fault)
