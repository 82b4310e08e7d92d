"""The links at the foot of a page, to the one before and the one after, stay in its language.

MkDocs turns the pages in the order of the menu, where the lessons of one language follow those of
another: the last lesson in English would lead on into Malay, and the sandbox back into Chinese.
And in the menu of a lesson those of its language stand first.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise

from mkdocs.structure.nav import Section
from mkdocs.structure.pages import Page

from sim.pages.language import ENGLISH, LANGUAGES, language_folder


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


def own_lessons_first(parts: Iterable[object], page: str) -> None:
    """In each of the `parts` of a menu that has lessons of several languages, those of the language
    of `page` come first. The others keep the order of `with_lessons`."""
    own = LANGUAGES.get(language_folder(page) or "")
    names = [LANGUAGES[language] for language in sorted(LANGUAGES)]

    def place(one: object) -> int:
        if not isinstance(one, Section) or one.title not in names:
            return 0  # in English
        return -1 if one.title == own else 1 + names.index(one.title)

    for part in parts:
        if isinstance(part, Section):
            part.children.sort(key=place)
