"""Files that join a site from elsewhere: pages of effects, and ready pages beside bare lessons."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import cast

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

from sim.pages.language import ENGLISH, of_page, speaking, words
from sim.pages.site import effect_pages, lessons_only
from sim.pages.site.files import SEARCH_FROM_DISK, search_from_disk
from sim.pages.text.lesson_places import shown
from sim.pages.translate.translation import Translation


class MadeFile(File):
    """A page that nobody wrote as a file: a preview makes it again when its sources change."""

    changed: float = 0.0

    def is_modified(self) -> bool:
        """Called by MkDocs."""
        made = Path(self.abs_dest_path)
        return not made.is_file() or made.stat().st_mtime < self.changed


def add_effect_pages(files: Files, config: MkDocsConfig) -> None:
    """Each effect has its page in its own folder; the index of this site's docs lists them."""
    index = files.get_file_from_path(effect_pages.INDEX)
    if index is None:
        return
    text = effect_pages.index_text(index.content_string)
    files.remove(index)
    listed = File.generated(config, effect_pages.INDEX, content=text)
    listed.edit_uri = index.edit_uri
    files.append(listed)
    for uri, path in effect_pages.effect_pages().items():
        file = File.generated(config, uri, abs_src_path=str(path))
        file.edit_uri = f"../sim/effects/{path.parent.name}/{path.name}"
        files.append(file)


def add_translations(
    files: Files, config: MkDocsConfig, root: Path, pages: Mapping[str, Translation]
) -> None:
    """Lessons that are made of a text and a catalogue; the edit button leads to the catalogue."""
    beside = _named(next(iter(pages.values())).source.path.parent) if pages else []
    for uri, one in pages.items():
        language = one.source.language
        others = {o.source.page.name for o in pages.values() if o.source.language == language}
        by_hand = {path.name for path in one.source.page.parent.glob("*.md")}
        made = MadeFile.generated(config, uri, content=one.page(others | by_hand))
        file = cast("MadeFile", made)
        file.changed = one.changed(beside)
        file.edit_uri = f"../{shown(one.source.catalogue, root)}"
        files.append(file)


def _named(folder: Path) -> list[Path]:
    """What lessons in a folder may name: all but lessons and their catalogues."""
    found = (path for path in folder.rglob("*") if path.suffix not in (".md", ".po"))
    return [path for path in found if path.is_file()]


def leave_out(files: Files, config: MkDocsConfig, *, from_disk: bool) -> None:
    """Source maps; a list of addresses where the site has none; and on a disk the word lists of
    other languages, which the search could not load there. Its worker becomes a script."""
    for file in list(files):
        words = from_disk and "/javascripts/lunr/" in file.src_uri
        if words or file.src_uri.endswith(".map") or file.src_uri == "sitemap.xml":
            files.remove(file)
        elif re.fullmatch(r"assets/javascripts/workers/search\..*\.js", file.src_uri):
            script = search_from_disk(file.content_string)
            files.append(File.generated(config, SEARCH_FROM_DISK, content=script))


def put_ready_pages(
    files: Files, config: MkDocsConfig, folder: Path, paths: Iterable[Path], names: Iterable[str]
) -> None:
    """Nothing of the lessons' folder stands at the root (banks hold keys): our pages do."""
    for file in [f for f in files if Path(f.abs_src_path or "/").resolve().is_relative_to(folder)]:
        files.remove(file)
    about = config.site_description or ""
    inside = {path.relative_to(folder).as_posix(): path for path in paths}
    lessons = {f"{folder.name}/{name}": path for name, path in inside.items()}
    language = of_page(None, "", str(config.theme.get("language") or ENGLISH))
    for name in sorted(names):
        with speaking(words(language)):
            text = lessons_only.ready_page(name, config.site_name, about, lessons)
        if text is not None:
            files.append(File.generated(config, name, content=text))
