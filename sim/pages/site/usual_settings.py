"""What every site of ours has where its mkdocs.yml does not say otherwise: Markdown and look.

Lessons are written in this Markdown: without it text that should wait stands open, and formulas
lose their signs. It comes from here, so that a later version can better it. What stands in
mkdocs.yml wins.
"""

from __future__ import annotations

import logging
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.utils.yaml import yaml_load

FEATURES = ["navigation.tabs", "navigation.footer", "toc.follow"]
PALETTE = [
    {
        "media": f"(prefers-color-scheme: {scheme})",
        "scheme": name,
        "primary": "custom",
        "accent": "custom",
        "toggle": {"icon": f"material/weather-{icon}", "name": other},
    }
    for scheme, name, icon, other in (
        ("light", "default", "night", "Dark"),
        ("dark", "slate", "sunny", "Light"),
    )
]
EXTENSIONS: Mapping[str, Mapping[str, Any]] = {
    "admonition": {},
    "attr_list": {},
    "def_list": {},
    "footnotes": {},
    "md_in_html": {},
    "pymdownx.arithmatex": {"generic": True},
    "pymdownx.details": {},
    "pymdownx.superfences": {},
    "sane_lists": {},
    "tables": {"use_align_attribute": True},
    "toc": {"permalink": True, "permalink_title": ""},
}
"""As in this project's own mkdocs.yml; a test holds the two together."""

INCLUDED = {
    "extra": {"attr_list", "def_list", "footnotes", "md_in_html", "tables"},
    "pymdownx.extra": {"attr_list", "def_list", "footnotes", "md_in_html", "tables"}
    | {"pymdownx.superfences"},
}
"""What sets of extensions bring: a second one of the name would take the place of theirs."""

_WARNED = {"nav": ("absolute_links",), "links": ("absolute_links", "unrecognized_links", "anchors")}
"""Links that are looked at, by the part of `validation` they belong to."""


def fill_in(config: MkDocsConfig, *, links: bool) -> None:
    """Give the settings of the generator what mkdocs.yml does not say. `links`: and have them
    looked at; pages of a site's own, which it had before, are not to fail for that."""
    stated = _stated(Path(config.config_file_path))
    theme = stated.get("theme")
    named = theme if isinstance(theme, dict) else {}  # or a name alone
    if "font" not in named:
        config.theme["font"] = False  # ours come with the site; others would be fetched
    for name, usual in (("features", FEATURES), ("palette", PALETTE)):
        if named.get(name) is None:
            config.theme[name] = usual
    there = _names_of(config.markdown_extensions)
    for name, settings in EXTENSIONS.items():
        if name not in config.markdown_extensions:
            if name in there:
                continue  # with settings of the site's own
            config.markdown_extensions.append(name)
        own = config.mdx_configs.get(name) or {}
        if missing := {key: value for key, value in settings.items() if key not in own}:
            config.mdx_configs[name] = {**own, **missing}
    config.extra.setdefault("generator", False)
    for part, name in _unsaid(stated.get("validation") or {}) if links else ():
        setattr(getattr(config.validation, part), name, logging.WARNING)


def _names_of(extensions: Iterable[str]) -> set[str]:
    """What they are, by the names that we use: a module's is `markdown.extensions.footnotes`."""
    short = {name.removeprefix("markdown.extensions.") for name in extensions}
    return short.union(*(INCLUDED.get(name, set()) for name in short))


def _stated(settings: Path) -> dict[str, Any]:
    """What stands in mkdocs.yml: in MkDocs' object its own defaults look the same."""
    with settings.open("rb") as file:
        return yaml_load(file)


def _unsaid(validation: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """What mkdocs.yml says neither for all links nor for those of one part."""
    for part, names in _WARNED.items():
        own = validation.get(part) or {}
        yield from ((part, name) for name in names if name not in own and name not in validation)
