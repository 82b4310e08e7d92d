"""The page that a web server shows for an address that leads nowhere: where to go from there."""

from __future__ import annotations

import re

from sim.pages.language import ENGLISH, of_page, speaking, tr, words

THEMES = "<h1>404 - Not found</h1>"
"""All that the theme says."""


def with_help(html: str, root: str) -> str:
    """The theme's page with a way home, in the site's language; any other page as it is. `root`
    leads to the site's folder, with a slash at its end; "" where the page lies in it."""
    if THEMES not in html:
        return html
    with speaking(words(language_in(html))):
        told = (
            f"<h1>{tr('This page is not here')}</h1>\n"
            f"<p>{tr('It may have moved, or its address is not quite right.')}</p>\n"
            f'<ul><li><a href="{root}index.html">{tr("Home, with all lessons")}</a></li>\n'
            f"<li>{tr('or look for a word of it: the search is at the top of the page')}</li></ul>"
        )
    return html.replace(THEMES, told, 1)


def language_in(html: str) -> str:
    """The language of ours that a page of the theme is in."""
    theme = re.search(r'<html lang="([\w-]+)"', html)
    return of_page(None, "", theme[1] if theme else ENGLISH)
