"""The words around a lesson, the theme's own (*Search*, *Next*) and the menu's (*Lessons*), in the
language of each page.

A site has one language for the theme, and lessons in several. The theme reads its words from
`partials/language.html`, made for the language of the site; the one below asks for the page's.
What mkdocs.yml calls the parts of the menu is said as our catalogues have it. A teacher's own
names stay: no catalogue knows them.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from jinja2 import ChoiceLoader, DictLoader, Environment

from sim.pages.language import UnknownLanguageError, language_folder, mark, of_page, words

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
_MENU = {
    "partials/palette.html": ("option.toggle.name",),
    "partials/tabs-item.html": ("ref.title",),
    "partials/nav-item.html": ("nav_item.title",),
    "partials/path-item.html": ("nav_item.title",),
    "partials/footer.html": ("page.previous_page.title", "page.next_page.title"),
}
"""Templates that say a name from mkdocs.yml, and what they call it."""
MENU_WORDS = frozenset(
    {
        mark("About"),
        mark("Dark"),
        mark("For teachers"),
        mark("Gallery"),
        mark("Home"),
        mark("Lessons"),
        mark("Light"),
        mark("Physics and accuracy"),
        mark("Sandbox"),
    }
)
"""The top row of the menu in our mkdocs.yml, and its switch. What is below them is in English, as
those pages are."""


def speak(env: Environment, of_site: str, templates: frozenset[str]) -> None:
    """Change the theme's templates in place. `of_site`: the theme's language in mkdocs.yml."""
    if env.loader is None or not {_LANGUAGE, _SEARCH} <= templates:
        return  # another theme
    search, *_ = env.loader.get_source(env, _SEARCH)
    ours = {
        _LANGUAGE: _TEMPLATE,
        _SEARCH: search.replace(_NAMELESS, _NAMED, 1),
    }
    for file, names in _MENU.items():
        if file in templates:
            source, *_ = env.loader.get_source(env, file)
            for name in names:  # also where it is escaped: {{ name | e }}
                source = re.sub(
                    rf"\{{\{{ {re.escape(name)}( \| e)? \}}\}}",
                    rf"{{{{ menu_word(page, {name})\1 }}}}",
                    source,
                )
            ours[file] = source
    env.globals["theme_words"] = _chosen(templates, of_site)
    env.globals["menu_word"] = _named(of_site)
    env.loader = ChoiceLoader([DictLoader(ours), env.loader])


def _named(of_site: str) -> Callable[[Any, str], str]:
    def menu_word(page: Any, name: str) -> str:
        """A name of mkdocs.yml in the language of the page. `page`: None for one without a file."""
        if name not in MENU_WORDS:
            return name
        stated, file = (page.meta.get("language"), page.file.src_uri) if page else (None, "")
        try:
            return words(of_page(stated, file, of_site)).get(name, name)
        except UnknownLanguageError:  # reported where the page is read
            return name

    return menu_word


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
