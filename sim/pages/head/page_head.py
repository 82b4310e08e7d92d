"""The last step of every page: its policy, its names, and only the scripts and sheets it needs.

The policy must be the first element of <head>: what stands before it is not covered.
"""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from html import escape
from typing import Any

from sim.lesson.opening import word_sum
from sim.pages.head.policy import Audience, inline_scripts, is_trusted, policy_of_page
from sim.pages.head.watchdog import watchdog
from sim.pages.language import ENGLISH, OWN, speaking, words
from sim.pages.text.films import plays_films
from sim.pages.text.formulas import SHEET

# Firefox prefetches these pages, which the policy rightly forbids; the links in the footer stay.
_NEIGHBOURS = re.compile(r'[ \t]*<link rel="(?:prev|next)"[^>]*>\n?')
# Over these a reader who hears the page stumbles: a link whose name is not its text (the theme's
# footer), and the head of a column without a word (Markdown's tables).
_RENAMED = re.compile(r'(<a [^>]*class="md-footer__link [^"]*") aria-label="[^"]*"')
_EMPTY_HEAD = re.compile(r'<th(?: scope="col")?( style="[^"]*")?></th>')

_KINDS = re.compile(r'<html [^>]*class="no-js')
WORD_OF = "teacher"  # what the checksum of a teacher's word belongs to


@dataclass(frozen=True, slots=True)
class Needs:
    """What a page needs beside the theme."""

    scenes: bool = False
    formulas: bool = False
    outline: Mapping[str, Any] | None = None  # of what can be answered here; None: nothing
    classroom: bool = False
    reports: bool = False  # tables as of class results
    measured: bool = False  # readings of real carts
    printed: bool = False  # made to be printed: cards, a lesson on paper
    own_words: tuple[str, ...] = ()  # elements whose words are a script of their own
    language: str = ENGLISH  # of the interface words
    challenge: bool = False  # a goal for the runs of a scene
    worlds: bool = False  # impossible ones, beside a scene
    hosted: bool = False  # on a web server: how to take it home
    law: bool = False  # a law that a reader writes
    tools: bool = False  # that a reader works in a scene
    films: bool = False  # or sounds, beside the page


def needs_of(
    html: str, *, scenes: bool, outline: Mapping[str, Any] | None, language: str, hosted: bool
) -> Needs:
    """What a rendered page needs, by what stands in it."""
    return Needs(
        scenes=scenes,
        formulas='class="arithmatex"' in html,
        outline=outline,
        classroom="<carts-class" in html,
        reports="carts-class-report" in html,
        measured="<carts-measured" in html,
        printed='class="carts-paper-' in html,
        own_words=own_words(html, language),
        language=language,
        challenge="<carts-challenge" in html,
        worlds="<carts-worlds" in html,
        hosted=hosted,
        law="<carts-law" in html,
        tools='class="carts-tools"' in html,
        films=plays_films(html),
    )


def own_words(html: str, language: str) -> tuple[str, ...]:
    """The elements of a page that bring words of their own along; English needs none."""
    if language == ENGLISH:
        return ()
    return tuple(element for element in OWN if f"<carts-{element}" in html)


# Half a formula is narrower than the whole: the first picture of a page with formulas waits for
# the end of its text; without a scene, for the theme's script too, which moves lines on a phone.
_READ = '<span id="carts-read" hidden></span>\n'
_WHEN_READ = '<link rel="expect" href="#carts-read" blocking="render">'
_SHEET = '<link rel="stylesheet"'
_THEME_SCRIPTS = '<script id="__config"'  # where the theme's scripts begin, below the page's text


def finish(
    page: str,
    *,
    audience: Audience,
    site_id: str,
    page_id: str,
    teacher_word: str = "",
    assets: str,
    needs: Needs,
    trusted: Collection[re.Pattern[str]],
) -> str:
    """The page with its policy, its site's and its own name, and the scripts that it needs.

    Under the two names the page keeps what a reader types: a moved folder finds it again. It knows
    a checksum of the teacher's word, which keeps a reader from the answers, not somebody who reads
    the page's files.

    `assets` leads from the page to the folder assets/carts/, with a slash at its end.
    """
    with speaking(words(needs.language)):
        watching = watchdog()
    allowed = [script for script in inline_scripts(page) if is_trusted(script, trusted)]
    first = (
        f'<head>\n    <meta http-equiv="Content-Security-Policy" '
        f'content="{policy_of_page(audience, [*allowed, watching], films=needs.films)}">\n'
        f'    <meta name="carts-site" content="{escape(site_id)}">\n'
        f'    <meta name="carts-page" content="{escape(page_id)}">'
    )
    if teacher_word:
        first += f'\n    <meta name="carts-teacher" content="{word_sum(WORD_OF, teacher_word)}">'
    sheets = ["site.css", "carts.css", *(["measured.css"] if needs.measured else [])]
    sheets += ["class.css"] if needs.classroom or needs.reports else []
    sheets += ["sheets.css"] if needs.printed else []
    last = [f'<link rel="stylesheet" href="{assets}{name}">' for name in sheets]
    if needs.formulas:
        last += [
            _WHEN_READ,
            f'<link rel="stylesheet" href="{assets}katex/katex.min.css">',
            f'<link rel="stylesheet" href="{assets}{SHEET}">',
            f'<script src="{assets}formula-fonts.js"></script>',
        ]
    page = _EMPTY_HEAD.sub(r"<td\1></td>", _RENAMED.sub(r"\1", page))
    page = _NEIGHBOURS.sub("", page).replace("<head>", first, 1)
    # Before the theme's own script: a scene answers to Play while that is still being read.
    place = _THEME_SCRIPTS if _THEME_SCRIPTS in page else "</body>"
    scripts = "".join(f"{line}\n" for line in _scripts(assets, needs))
    page = page.replace(place, f"{scripts}{place}", 1)
    if needs.formulas:
        end = scripts if needs.scenes else "</body>"
        page = page.replace(end, f"{_READ}{end}", 1)
    if needs.language != ENGLISH:
        page = re.sub(r'<html lang="[\w-]*"', f'<html lang="{needs.language}"', page, count=1)
    page = page.replace("</head>", "".join(f"{line}\n" for line in last) + "</head>", 1)
    # Before all sheets: a script behind one waits for it, for ever if that never comes.
    page = page.replace(_SHEET, f"<script>{watching}</script>\n{_SHEET}", 1)
    return _KINDS.sub(lambda html: " ".join([html[0], *kinds_of(needs)]), page, count=1)


def kinds_of(needs: Needs) -> list[str]:
    """Classes of the whole page, for its sheets: `:root:has(carts-scene)` would say the same, and
    browsers would ask it anew with every word that changes, 60 times a second in a run."""
    kinds = {"carts-with-scenes": needs.scenes, "carts-with-questions": needs.outline is not None}
    return [kind for kind, there in kinds.items() if there]


def _scripts(assets: str, needs: Needs) -> Iterator[str]:
    """The scripts of ours that a page needs: first what is asked on it, by which a prediction knows
    whether what was kept answers that; the words of its language before those that say them; and on
    every page the one that keeps answers and has the panel “My answers”."""
    if needs.outline is not None:
        text = json.dumps(needs.outline, ensure_ascii=False, separators=(",", ":"))
        text = text.replace("<", "\\u003c")
        yield f'<script type="application/json" id="carts-lesson">{text}</script>'
    names = [f"words.{needs.language}.js"] if needs.language != ENGLISH else []
    names += [f"words-{element}.{needs.language}.js" for element in needs.own_words]
    names += ["carts.js", "tour.js"] if needs.scenes else []
    names += ["tools.js"] if needs.tools else []
    names += ["challenge.js"] if needs.challenge else []
    names += ["worlds.js"] if needs.worlds else []
    names += ["hosted.js"] if needs.hosted else []
    names += ["law.js"] if needs.law else []
    names += ["measured.js"] if needs.measured else []
    names += ["class-keys.js", "class.js"] if needs.classroom else []
    yield from (f'<script src="{assets}{name}"></script>' for name in names)
    yield f'<script src="{assets}answers.js"></script>'
