"""The links at the foot of a page, to the one before and the one after, stay in its language.

MkDocs turns the pages in the order of the menu, where the lessons of one language follow those of
another: the last lesson in English would lead on into Malay, and the sandbox back into Chinese.
And in the menu of a lesson those of its language stand first, and those of others are folded away.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise

from mkdocs.structure.nav import Section
from mkdocs.structure.pages import Page

from sim.pages.language import ENGLISH, LANGUAGES, language_folder, speaking, tr, words


def turn_in_one_language(pages: Iterable[Page]) -> None:
    """Link the `pages` of a menu, in its order, to their neighbours in the same language; where a
    language begins and ends there is none."""
    rows: dict[str, list[Page]] = {}
    for page in pages:
        rows.setdefault(language_folder(page.file.src_uri) or ENGLISH, []).append(page)
    for row in rows.values():
        row[0].previous_page = row[-1].next_page = None
        for before, after in pairwise(row):
            before.next_page, after.previous_page = after, before


class _Others(Section):
    """The lessons in the languages that a page does not speak: each language is closed, so that
    nobody goes through all its lessons with the Tab key to come to the page."""


def own_lessons_first(parts: Iterable[object], page: str) -> None:
    """In each of the `parts` of a menu that has lessons of several languages, those of the language
    of `page` come first, and those in others than English last, under one name."""
    language = language_folder(page) or ENGLISH
    names = [LANGUAGES[one] for one in sorted(LANGUAGES)]
    for part in parts:
        if not isinstance(part, Section):
            continue
        all_ = [
            one
            for child in part.children
            for one in (child.children if isinstance(child, _Others) else [child])
        ]
        in_one = [one for one in all_ if isinstance(one, Section) and one.title in names]
        own = [one for one in in_one if one.title == LANGUAGES[language]]
        rest = sorted((one for one in in_one if one not in own), key=lambda o: names.index(o.title))
        part.children = [*own, *(one for one in all_ if one not in in_one)]
        if rest:
            with speaking(words(language)):
                others = _Others(tr("Other languages"), [*rest])
            others.parent = part
            part.children.append(others)
