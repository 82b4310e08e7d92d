"""The lines at the top of a lesson: its languages, and how far a translation has come."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Mapping
from html import escape
from urllib.parse import quote

from sim.pages.language import ENGLISH, LANGUAGES, language_folder, speaking, tr, words
from sim.pages.text.lesson_places import page_of

_END = "</h1>"


def languages_of(uri: str, uris: Iterable[str]) -> dict[str, str]:
    """The pages of the same lesson by language, English first; `uris`: all lessons of the site."""
    folder, name = _place(uri)
    found = {language_folder(one) or ENGLISH: one for one in uris if _place(one) == (folder, name)}
    return {language: found[language] for language in LANGUAGES if language in found}


def _place(uri: str) -> tuple[str, str]:
    """The folder of a lesson without that of its language, and its name."""
    folder, name = posixpath.split(uri)
    return (posixpath.dirname(folder) if language_folder(uri) else folder), name


def with_lines(html: str, lines: str) -> str:
    """The content of a page with the lines under its title."""
    head, end, rest = html.partition(_END)
    return f"{head}{end}\n{lines}{rest}" if end else lines + html


def language_line(uri: str, pages: Mapping[str, str], language: str) -> str:
    """Links to the same lesson in other languages; empty where there is none."""
    if len(pages) < 2:
        return ""
    listed = []
    for other, page in pages.items():
        name = f'<span lang="{other}">{escape(LANGUAGES[other])}</span>'
        if page == uri:
            listed.append(name.replace("<span", '<span aria-current="page"', 1))
        else:
            href = quote(posixpath.relpath(page_of(page), posixpath.dirname(uri)))
            listed.append(f'<a href="{href}" hreflang="{other}">{name}</a>')
    with speaking(words(language)):
        label = escape(tr("This lesson in other languages"))
    return (
        f'<p class="carts-languages" role="navigation" aria-label="{label}" data-search-exclude>'
        f"{' · '.join(listed)}</p>\n"
    )


def draft_line(language: str, *, draft: bool, left: int, parts: int) -> str:
    """What a reader should know of a translation; empty where it is read and whole."""
    with speaking(words(language)):
        said = [tr("This translation is a draft: no teacher has read it yet.")] if draft else []
        said += [tr("{left} of {parts} parts are in English.", left=left, parts=parts)] * (left > 0)
    text = escape(" ".join(said))
    return f'<p class="carts-draft" data-search-exclude>{text}</p>\n' if said else ""
