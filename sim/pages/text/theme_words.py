"""The theme's own words (*Search*, *Next*, *Table of contents*) in the language of each page.

A site has one language for the theme, and lessons in several. The theme reads its words from
`partials/language.html`, made for the language of the site; the one below asks for the page's.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from jinja2 import ChoiceLoader, DictLoader, Environment

from sim.pages.language import language_folder

_FILE = "partials/languages/{}.html"
_TEMPLATE = """\
{% import theme_words(page) as lang %}
{% import "partials/languages/en.html" as fallback %}
{% macro t(key) %}{{ lang.t(key) or fallback.t(key) or key }}{% endmacro %}
"""
_LANGUAGE = "partials/language.html"
_SEARCH = "partials/search.html"
_NAMELESS = 'role="dialog">'  # a dialog of which a screen reader cannot say what it is
_NAMED = """role="dialog" aria-label="{{ lang.t('search') }}">"""


def speak(env: Environment, of_site: str) -> None:
    """Change the theme's templates in place. `of_site`: the theme's language in mkdocs.yml."""
    templates = frozenset(env.list_templates())
    if env.loader is None or not {_LANGUAGE, _SEARCH} <= templates:
        return  # another theme
    search, *_ = env.loader.get_source(env, _SEARCH)
    ours = {
        _LANGUAGE: _TEMPLATE,
        _SEARCH: search.replace(_NAMELESS, _NAMED, 1),
    }
    env.globals["theme_words"] = _chosen(templates, of_site)
    env.loader = ChoiceLoader([DictLoader(ours), env.loader])


def _chosen(templates: frozenset[str], of_site: str) -> Callable[[Any], str]:
    def theme_words(page: Any) -> str:
        """The file of words for a page; for one without a Markdown file the site's."""
        code = _language(page) if page else ""
        known = (_FILE.format(one) for one in (code, code.partition("-")[0]))
        return next((file for file in known if file in templates), _FILE.format(of_site))

    return theme_words


def _language(page: Any) -> str:
    """What the front matter says, or the folder; "" where neither does. (A language without a
    catalogue of ours has been reported; the theme may have its words.)"""
    stated = page.meta.get("language")
    return str(stated or language_folder(page.file.src_uri)).replace("_", "-")
