"""Files in a folder of lessons that no page is made of, though somebody meant one; empty pages.

They do no harm to the pages that are built: it is said, and the build goes on.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from sim.pages.findings import Finding
from sim.pages.language import LANGUAGES
from sim.pages.text.fence_scan import after_front_matter
from sim.pages.text.lesson_places import BANK_FOLDER, LESSONS, is_built, shown
from sim.pages.text.plain_lines import lines_of
from sim.pages.translate.catalogues import FOLDER, catalogues_in


def no_page(path: Path, root: Path) -> list[Finding]:
    """That the lesson at `path` lies too deep in the folder of lessons of the site at `root`."""
    if makes_page(path, root) or _tells_of_its_folder(path):
        return []
    message = "no page is made of this lesson: it lies in a folder that is not built"
    hint = f"put it into {LESSONS}/, or into the folder of its language, such as {LESSONS}/ms/"
    return [Finding(shown(path, root), 1, 1, "not-built", message, hint, "warning")]


def makes_page(path: Path, root: Path) -> bool:
    """Whether the page at `path` joins the site at `root`, as all outside its lessons do."""
    folder = root / LESSONS
    return is_built(path, folder) or not path.is_relative_to(folder)


def no_text(text: str, file: str) -> list[Finding]:
    """That the lesson with this text has none, but for the facts at its top."""
    lines = lines_of(text)
    if any(line.strip() for line in lines[after_front_matter(lines) :]):
        return []
    message = "nothing is in this lesson yet: its page would be empty"
    hint = "write a heading, # First lesson, and below it the text; or delete the file"
    return [Finding(file, 1, 1, "empty", message, hint, "warning")]


def _tells_of_its_folder(path: Path) -> bool:
    """A README.md beside banks, scenes, words: nobody means it as a page."""
    return path.name == "README.md" and not any(
        one.name != path.name for one in path.parent.glob("*.md")
    )


def no_lesson(folder: Path, root: Path) -> Iterator[Finding]:
    """Catalogues in `folder` whose lesson or bank is not there: it was renamed, or taken away."""
    for words in sorted(place for place in folder.rglob(FOLDER) if _of_lessons(place)):
        for source in catalogues_in(words.parent):
            if not any(source.path.with_suffix(s).is_file() for s in (".md", ".yml", ".yaml")):
                name = shown(source.catalogue, root)
                bank = source.path.parent.name == BANK_FOLDER
                kind = "bank" if bank else "lesson"
                message = f"there is no {kind} “{source.path.stem}” that this is a translation of"
                hint = f"rename it as the {kind} is called now, or delete it"
                yield Finding(name, 1, 1, "no-original", message, hint, "warning")


def _of_lessons(place: Path) -> bool:
    """Whether a folder holds catalogues, by language."""
    return place.is_dir() and any((place / language).is_dir() for language in LANGUAGES)
