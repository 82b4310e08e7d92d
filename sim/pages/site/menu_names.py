"""Pages and files that mkdocs.yml names in vain, with their places.

A build stops at such a page too, but without a line, and after all other work; at a logo that is
not there it does not: readers see a broken picture. Plugins of others may make pages; where a site
has one that is not known to make none, only the build can tell.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import yaml

from sim.pages.findings import SiteError
from sim.pages.language import LANGUAGES
from sim.pages.site.effect_pages import PLACE, effect_pages
from sim.pages.site.lessons_only import CLASS_RESULTS, HOME
from sim.pages.text.lesson_places import LESSONS, check_folder
from sim.pages.translate.catalogues import FOLDER
from sim.scene.problem import did_you_mean

MAKE_NO_PAGES = frozenset(
    {"carts", "search", "offline", "privacy", "info", "optimize", "social", "meta"}
)
"""Plugins, the theme's own among them."""
_FOLDERS = (f"{LESSONS}/", PLACE)
"""Of which a menu shows all pages."""


def named_in_vain(
    root: Path, settings: dict[Any, yaml.Node]
) -> Iterator[tuple[yaml.ScalarNode, str, str]]:
    """What is named in vain: where, what is told of it, and a hint. `settings`: the parts of
    mkdocs.yml, by name."""
    docs = settings.get("docs_dir")
    folder = root / (docs.value if isinstance(docs, yaml.ScalarNode) and docs.value else "docs")
    plugins = dict(_plugins(settings.get("plugins")))
    if not {name.rpartition("/")[2] for name in plugins} <= MAKE_NO_PAGES:
        return
    if (docs and not folder.is_dir()) or _lessons_elsewhere(plugins.get("carts")):
        return  # that is the mistake, and told as one
    pages = _Pages(folder, root / LESSONS)
    for node in _named(settings.get("nav")):
        if _outside(node.value) or node.value in pages:
            continue
        told = f"the menu names “{node.value}”, and there is no such page"
        usual = "the name of a file, as in: - Home: index.md"
        folder_meant = node.value.endswith("/")
        if folder_meant:
            usual = f"all lessons, as in: - Lessons: {LESSONS}/"
        beside = f"{LESSONS}/{node.value}"  # it was counted from the folder of lessons
        meant = did_you_mean(node.value, _FOLDERS if folder_meant else pages.names(), usual)
        yield node, told, f"did you mean “{beside}”?" if beside in pages else meant
    for node in _files(settings):
        if not _outside(node.value) and not pages.has_file(node.value):
            told = f"there is no file “{node.value}” in this site"
            hint = f"put it into the folder {LESSONS}, and write {LESSONS}/{node.value}"
            yield node, told, hint


class _Pages:
    """The pages of a site before it is built: files, and what the build makes."""

    def __init__(self, docs: Path, lessons: Path) -> None:
        self.docs, self.lessons = docs, lessons
        self.lessons_only = docs.resolve() == lessons.resolve()

    def __contains__(self, name: str) -> bool:
        if name in _FOLDERS or name in effect_pages():
            return True
        if name.startswith(f"{LESSONS}/"):
            return self._is_lesson(name.partition("/")[2])
        if self.lessons_only:
            return name in (HOME, CLASS_RESULTS)
        return (self.docs / name).is_file()

    def _is_lesson(self, name: str) -> bool:
        if (self.lessons / name).is_file():
            return True
        language, _, original = name.partition("/")  # made of the original and a catalogue
        words = (self.lessons / FOLDER / language / original).with_suffix(".po")
        return language in LANGUAGES and words.is_file() and (self.lessons / original).is_file()

    def has_file(self, name: str) -> bool:
        """Whether a picture or a style sheet is there, of the site or of the theme."""
        places = [theme_templates() / name, *([] if self.lessons_only else [self.docs / name])]
        if name.startswith(f"{LESSONS}/"):
            places.append(self.lessons / name.partition("/")[2])
        return any(place.is_file() for place in places)

    def names(self) -> list[str]:
        """Those that may have been meant."""
        if self.lessons_only:
            found = [HOME, CLASS_RESULTS]
        else:
            found = [path.relative_to(self.docs).as_posix() for path in self.docs.rglob("*.md")]
        return [
            *found,
            *_FOLDERS,
            *(f"{LESSONS}/{path.name}" for path in self.lessons.glob("*.md")),
        ]


@cache
def theme_templates() -> Path:
    """The folder of the theme's files, or one that is not there where the theme is not."""
    theme = find_spec("material")
    return Path(theme.origin).parent / "templates" if theme and theme.origin else Path("-")


def _named(node: yaml.Node | None) -> Iterator[yaml.ScalarNode]:
    """What stands in a menu for a page or a folder of pages."""
    if isinstance(node, yaml.ScalarNode):
        if node.tag.endswith(":str"):
            yield node
    elif isinstance(node, yaml.SequenceNode):
        for entry in node.value:
            yield from _named(entry)
    elif isinstance(node, yaml.MappingNode):
        for _, entry in node.value:
            yield from _named(entry)


def _files(settings: dict[Any, yaml.Node]) -> Iterator[yaml.ScalarNode]:
    """What stands for the site's own pictures and style sheets."""
    theme = settings.get("theme")
    parts = theme.value if isinstance(theme, yaml.MappingNode) else []
    if all(key.value != "custom_dir" for key, _ in parts):  # a folder with files of the theme
        for key, value in parts:
            if key.value in ("logo", "favicon"):
                yield from _named(value)
        yield from _named(settings.get("extra_css"))


def _outside(name: str) -> bool:
    """Whether it is an address and no page of this site."""
    return "://" in name or name.startswith(("/", "#", "mailto:"))


def _plugins(node: yaml.Node | None) -> Iterator[tuple[str, yaml.Node | None]]:
    """The names under `plugins`, each with its settings."""
    if isinstance(node, yaml.ScalarNode):
        yield str(node.value), None
    elif isinstance(node, yaml.SequenceNode):
        for entry in node.value:
            yield from _plugins(entry)
    elif isinstance(node, yaml.MappingNode):
        yield from ((str(name.value), own) for name, own in node.value)


def _lessons_elsewhere(carts: yaml.Node | None) -> bool:
    """Whether the plugin is told of another folder of lessons than there is."""
    own = carts.value if isinstance(carts, yaml.MappingNode) else []
    named = [str(value.value) for key, value in own if key.value == "lessons"]
    try:
        for name in named:
            check_folder(name)
    except SiteError:
        return True
    return False
