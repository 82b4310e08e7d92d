"""What a preview remembers from one build to the next, so that an edit costs one page.

`carts serve` makes the whole site once, and after an edit the pages that it touches. The others
keep their files; their names in the menu are kept here, and the theme's compiled templates.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from jinja2 import BytecodeCache
from jinja2.bccache import Bucket

from sim.pages.blocks.scene_block import Lesson
from sim.pages.findings import AUTHOR_ERROR, Finding, error_box
from sim.pages.text.lesson_text import minutes_last, text_findings

if TYPE_CHECKING:
    from mkdocs.structure.nav import Navigation


class Compiled(BytecodeCache):
    """The theme's templates by their key, compiled; Jinja2 tells if a text is no longer the same.
    To compile them takes half as long as a small site does."""

    def __init__(self) -> None:
        self._templates: dict[str, bytes] = {}

    def load_bytecode(self, bucket: Bucket) -> None:
        """Called by Jinja2."""
        if found := self._templates.get(bucket.key):
            bucket.bytecode_from_string(found)

    def dump_bytecode(self, bucket: Bucket) -> None:
        """Called by Jinja2."""
        self._templates[bucket.key] = bucket.bytecode_to_string()


COMPILED = Compiled()
"""Of every site that this process builds."""


class Preview:
    """Names of pages by file."""

    def __init__(self) -> None:
        self.names: dict[str, str] = {}

    def name_pages(self, nav: Navigation) -> None:
        """Give pages the names that they had; those that are read again find their own."""
        for page in nav.pages:
            name = self.names.get(page.file.src_uri)
            if name and not page.file.is_modified():
                page.title = name


def text_box(text: str, page: str, lesson: Lesson, report: Callable[[Finding], None]) -> str:
    """A red box with the mistakes in the text around the blocks, or nothing. `page`: what was made
    of the text, with the boxes of its blocks."""
    found = minutes_last(text_findings(text, lesson), wrong=AUTHOR_ERROR in page)
    for finding in found:
        report(finding)
    return error_box(tuple(found), "To be mended on this page") if found else ""


def touched(changed: Iterable[Path], pages: Iterable[Path]) -> set[Path]:
    """The pages to make again: the changed ones, and those that name another changed file."""
    changed = set(changed)
    names = [path.name for path in changed if path.suffix != ".md"]
    return {
        page
        for page in pages
        if page in changed
        or (names and any(name in page.read_text("utf-8", "replace") for name in names))
    }
