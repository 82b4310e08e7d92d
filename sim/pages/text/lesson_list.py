"""The lessons of a site: their files in order, and their places in the menu."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from sim.pages.language import LANGUAGES, language_folder
from sim.pages.text.front_matter import lesson_order
from sim.pages.text.lesson_places import is_hidden


def lessons_in(folder: Path) -> list[Path]:
    """The lessons of a site in their order, then those in the folders of other languages."""
    folders = [folder, *(folder / language for language in sorted(LANGUAGES))]
    return [path for one in folders for path in sorted(_pages(one), key=lesson_order)]


def _pages(folder: Path) -> list[Path]:
    return [path for path in folder.glob("*.md") if not is_hidden(path.relative_to(folder))]


def with_lessons(nav: list[Any], folder: Path, lessons: Iterable[Path]) -> list[Any]:
    """The navigation with `folder/` replaced by all lessons in it; each language has a part."""
    pages: list[Any] = []
    others: dict[str, list[str]] = {}
    for path in lessons:
        address = path.relative_to(folder.parent).as_posix()
        language = language_folder(address)
        (others.setdefault(LANGUAGES[language], []) if language else pages).append(address)
    pages += [{name: listed} for name, listed in others.items()]

    def stands_for_them(item: Any) -> bool:
        return isinstance(item, dict) and list(item.values()) == [f"{folder.name}/"]

    return [dict.fromkeys(item, pages) if stands_for_them(item) else item for item in nav]
