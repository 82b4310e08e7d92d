"""What the build and teacher mode do with a lesson's text when it has become a tree of elements.

Notes that wait (`!!! after`) become elements of their own: they open as questions do, and search
passes them. Headings in them stay out of the table of contents, which is read before any
prediction. A heading leaves the address that a block has to the block. Headings of parts say how
long they take. Pictures that are films are played.
"""

from __future__ import annotations

import html
from collections.abc import Callable, Collection
from contextlib import AbstractContextManager
from typing import Any
from xml.etree.ElementTree import Element

from markdown import Markdown
from markdown.extensions.toc import remove_fnrefs, render_inner_html, strip_tags, unique
from markdown.treeprocessors import Treeprocessor

from sim.pages.language import tr
from sim.pages.text.films import show_films
from sim.pages.text.held_back import MARK
from sim.pages.text.part_lengths import add_lengths

WAITING = "carts-after"
_WIDE = "carts-wide"  # a note that holds a scene is as wide as one
_HIDDEN = "carts-hidden-"  # in front of the tag of a heading, while the contents are listed
_HEADINGS = tuple(f"h{level}" for level in range(1, 7))

_AFTER_TEXT = 15  # when the text within has become HTML (20), before it is written out
_AFTER_ATTRIBUTES = 6  # when {: … } of a heading has become attributes (8), before the contents (5)
_AFTER_CONTENTS = 4
_AFTER_ADDRESSES = -1  # when the generator has made addresses of pages and files (0)


def add_steps(
    md: Markdown,
    *,
    waits: Callable[[str], str],
    wide: Callable[[Element], bool],
    taken: Callable[[], Collection[str]],
    spoken: Callable[[], AbstractContextManager[None]],
) -> None:
    """Register them. `waits`: what to write, as text of a paragraph, where something waits for the
    run of a scene; empty: nothing waits here. `wide`: whether a note holds a scene. `taken`: the
    ids in the page's blocks. `spoken`: makes the page's language that of the words."""

    def lengths(root: Element) -> None:
        with spoken():
            add_lengths(root)

    def films(root: Element) -> None:
        with spoken():
            show_films(root, tr("The film as a file"))

    def hide(root: Element) -> None:
        _hide_headings(root, _namer(md), taken())

    for name, when, do in (
        ("carts_after", _AFTER_TEXT, lambda root: _hold_back(root, waits, wide)),
        ("carts_hidden", _AFTER_ATTRIBUTES, hide),
        ("carts_seen", _AFTER_CONTENTS, _show_headings),
        ("carts_lengths", _AFTER_CONTENTS - 1, lengths),
        ("carts_films", _AFTER_ADDRESSES, films),
    ):
        md.treeprocessors.register(_Step(md, do), name, when)


class _Step(Treeprocessor):
    """A function as one of Markdown's steps."""

    def __init__(self, md: Markdown, do: Callable[[Element], None]) -> None:
        super().__init__(md)
        self.do = do

    def run(self, root: Element) -> None:
        self.do(root)


def _hold_back(root: Element, waits: Callable[[str], str], wide: Callable[[Element], bool]) -> None:
    for note in root.iter("div"):
        classes = (note.get("class") or "").split()
        mark = next((name for name in classes if name.startswith(MARK)), "")
        told = waits(mark.removeprefix(MARK)) if mark else ""
        if not told:
            continue
        classes.remove(mark)
        note.tag = WAITING
        note.set("class", " ".join([*classes, *([_WIDE] if wide(note) else [])]))
        note.set("data-after", mark.removeprefix(MARK))
        note.set("data-search-exclude", "")
        line = Element("p")
        line.text = told
        note.insert(0, line)


def _namer(md: Markdown) -> Callable[[Element], str] | None:
    """How the contents make an id of a heading, by their own steps: tags, entities and footnotes
    stand elsewhere at this time, with numbers in their places. None where there are no contents."""
    if "toc" not in md.treeprocessors:
        return None
    toc: Any = md.treeprocessors["toc"]

    def named(heading: Element) -> str:
        text = strip_tags(render_inner_html(remove_fnrefs(heading), md))
        return str(toc.slugify(html.unescape(text), toc.sep))

    return named


def _hide_headings(
    root: Element, named: Callable[[Element], str] | None, blocks: Collection[str]
) -> None:
    """The contents list what is called h1 to h6. `named`: from a heading to its id, if headings get
    one there: then these too, as they would have, so that links to them lead on. An id in `blocks`
    is not theirs: a scene is looked for by it, and answers are filed under it."""
    hidden = _held(root, _HEADINGS)
    if named:
        taken = {*blocks, *(name for one in root.iter() if (name := one.get("id")))}
        for heading in root.iter():
            if heading.tag in _HEADINGS and not heading.get("id"):
                heading.set("id", unique(named(heading), taken))
    for heading in hidden:
        heading.attrib.pop("data-toc-label", None)
        heading.tag = _HIDDEN + heading.tag


def _show_headings(root: Element) -> None:
    for heading in _held(root, tuple(_HIDDEN + tag for tag in _HEADINGS)):
        heading.tag = heading.tag.removeprefix(_HIDDEN)


def _held(root: Element, tags: tuple[str, ...]) -> list[Element]:
    """Elements with one of these tags in text that waits, once: notes may stand in notes."""
    inside = (one for note in root.iter(WAITING) for one in note.iter() if one.tag in tags)
    return list({id(one): one for one in inside}.values())
