"""Blocks of ours without their name: ``` alone, or ```frage, above the lines of a question.

Markdown prints such a block as code, and students read which answer is right.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from sim.pages.text.fence_scan import Block, fenced, meant_kind
from sim.pages.text.plain_lines import lines_of

_MEANT_AS_WRITTEN = frozenset({
    *("yaml", "yml", "json", "toml", "ini", "text", "txt", "plain", "md", "markdown"),
    *("python", "py", "html", "xml", "console", "sh", "bash", "js", "javascript", "ts"),
    *("typescript", "graphql", "mermaid", "properties", "log", "c", "rust"),
})  # fmt: skip
"""Code that may look like a block of ours, and is to be printed."""
_LANGUAGE = re.compile(r"[a-z]\w*")
_ID = re.compile(r"\s*id:[ \t]*\S")
_SCENE = re.compile(r"^(?:carts:|file:[ \t]*\S+\.ya?ml\b)", re.MULTILINE)
_QUIZ = re.compile(r"^(?:bank|form):", re.MULTILINE)
_QUESTION = re.compile(r"^type:|\bcorrect:", re.MULTILINE)


def nameless(text: str) -> Iterator[tuple[int, str, str, str]]:
    """Where each begins, with what is told of it."""
    lines = lines_of(text, keepends=True)
    for block in fenced(lines):
        kind = _kind(block.body)
        if not kind or meant_kind(block.name) or _called(block) in _MEANT_AS_WRITTEN:
            continue
        what = f"“{block.name[:30]}” is no name of a block" if block.name else "it has no name"
        told = f"this block would be printed as code, right answers included: {what}"
        at = sum(map(len, lines[: block.start])) + len(block.indent)
        yield at, "nameless-block", told, f"write ```{kind}"


def _called(block: Block) -> str:
    """The language that a fence names, as in ```{ .yaml }."""
    return next(iter(_LANGUAGE.findall(f"{block.name} {block.rest}".lower())), "")


def _kind(body: str) -> str:
    """What its keys are those of; empty: of no block of ours."""
    if not _ID.match(body):
        return ""
    kinds = {"question": _QUESTION, "quiz": _QUIZ, "scene": _SCENE}
    return next((kind for kind, keys in kinds.items() if keys.search(body)), "")
