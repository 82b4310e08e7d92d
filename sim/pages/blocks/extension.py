"""The Markdown extension: blocks become live scenes and questions, mistakes become red boxes.

It works with any generator that uses Python-Markdown. The generator's shell says with `set_page`
which page is being made and what shall happen with findings; without it the first mistake raises
`AuthorError`. Blocks are taken out before any other extension sees them, because pymdownx would
swallow an exception and show the block as code.
"""

from __future__ import annotations

import hashlib
import re
from contextlib import AbstractContextManager
from contextvars import ContextVar
from xml.etree.ElementTree import Element

from markdown import Extension, Markdown
from markdown.postprocessors import Postprocessor
from markdown.preprocessors import Preprocessor

from sim.pages.blocks.makers import MAKERS, Page, made
from sim.pages.blocks.scene_block import Lesson
from sim.pages.findings import AuthorError, error_box
from sim.pages.language import speaking, words
from sim.pages.text.fence_scan import scan
from sim.pages.text.held_back import mark_held
from sim.pages.text.plain_lines import without_code
from sim.pages.text.sections import in_sections, title_of
from sim.pages.text.steps import add_steps

__all__ = [
    "MAKERS",
    "CartsExtension",
    "Page",
    "makeExtension",
    "set_page",
    "with_late",
]

# Before Markdown's own clean-up (30), which turns tabs into spaces and so hides them.
_BEFORE_EVERYTHING = 40
# After all others: what stands in the place of a block is then only text in a paragraph.
_AFTER_EVERYTHING = -10
_WORD = "cartsblock"
_ID = re.compile(r'\sid="([^"]+)"')
_NOT_TO_SEARCH = re.compile(r"\s*<[a-z-]+ [^>]*\bdata-search-exclude\b")


_page: ContextVar[Page | None] = ContextVar("carts-page", default=None)


def set_page(page: Page | None) -> None:
    """From now on the extension works for `page`; None: for nobody."""
    _page.set(page)


class CartsExtension(Extension):
    """Registers the two steps: take the blocks out, put the scenes in."""

    def extendMarkdown(self, md: Markdown) -> None:  # noqa: N802
        """Called by Python-Markdown."""
        put_in = _PutIn(md)
        md.preprocessors.register(_TakeOut(md, put_in), "carts_blocks", _BEFORE_EVERYTHING)
        add_steps(
            md,
            waits=put_in.waits,
            wide=put_in.holds_scene,
            taken=lambda: put_in.ids,
            spoken=_spoken,
        )
        md.postprocessors.register(put_in, "carts_blocks", _AFTER_EVERYTHING)


def makeExtension(**config: object) -> CartsExtension:  # noqa: N802
    """Python-Markdown's entry point."""
    return CartsExtension(**config)


class _TakeOut(Preprocessor):
    """Replaces every block by a word that no other extension touches."""

    def __init__(self, md: Markdown, put_in: _PutIn) -> None:
        super().__init__(md)
        self.put_in = put_in

    def run(self, lines: list[str]) -> list[str]:
        self.put_in.html.clear()
        self.put_in.scenes.clear()
        self.put_in.ids.clear()
        page = _page.get() or Page(Lesson("lesson"))
        page.title = title_of(lines)
        kept: list[str] = []
        done = 0
        # Front matter has been removed by the generator: a line of --- here is only a line.
        page.blocks = tuple(scan(lines, front_matter=False))
        plain = without_code("\n".join(lines)).split("\n")
        for block, section in in_sections(lines, page.blocks):
            mark_held(lines, plain, done, block.start, page.items.asking, page.items.scene_ids)
            page.section = section
            if section.new:
                page.items.asking = ""  # its questions are about other scenes
            try:
                html = made(block, page)
            except AuthorError as error:
                if page.report is None:
                    raise
                page.items.give_up(block)
                for finding in error.findings:
                    if not page.items.follows(finding):
                        page.report(finding)
                html = error_box(error.findings)
            self.put_in.ids.update(_ID.findall(html))
            word = f"{_WORD}{hashlib.sha256(f'{block}'.encode()).hexdigest()[:16]}"
            if page.late is not None and _NOT_TO_SEARCH.match(html):
                stub = f"<!--late {word.removeprefix(_WORD)}-->"  # without the word itself
                page.late[stub] = html
                html = stub
            self.put_in.html[word] = html
            if block.name == "scene":
                self.put_in.scenes.add(word)
            kept += [*lines[done : block.start], "", block.indent + word, ""]
            done = block.end
        mark_held(lines, plain, done, len(lines), page.items.asking, page.items.scene_ids)
        for finding in page.items.first_causes(()):
            if page.report is None:
                raise AuthorError([finding])
            page.report(finding)
        return [*kept, *lines[done:]]


def _spoken() -> AbstractContextManager[None]:
    """The words of the page's language."""
    page = _page.get()
    return speaking(words(page.language) if page else {})


def with_late(html: str, late: dict[str, str] | None) -> str:
    """The page with its pictures in their places: search and checks need not read them."""
    for stub, block in (late or {}).items():
        html = html.replace(stub, block)
    return html


class _PutIn(Postprocessor):
    """Replaces the words by what was made of their blocks."""

    def __init__(self, md: Markdown) -> None:
        super().__init__(md)
        self.html: dict[str, str] = {}
        self.scenes: set[str] = set()  # the words among these that stand for a scene
        self.ids: set[str] = set()  # in what was made of the blocks

    def waits(self, scene: str) -> str:
        """The word for the line that says what the text waits for; empty where no page is made."""
        page = _page.get()
        if page is None:
            return ""
        from sim.pages.question.render import waits_line

        # No link of Markdown's tree: the generator would look for the scene, which is put in later.
        word = f"{_WORD}{len(self.html)}waits"
        with speaking(words(page.language)):
            self.html[word] = waits_line(scene, page.items.runs(scene))
        return word

    def holds_scene(self, note: Element) -> bool:
        """Whether a scene is put into it later."""
        return not self.scenes.isdisjoint(map(str.strip, note.itertext()))

    def run(self, text: str) -> str:
        for word, block in self.html.items():
            # A paragraph may not contain a scene; in a tight list there is no paragraph.
            text = text.replace(f"<p>{word}</p>", block).replace(word, block)
        return text
