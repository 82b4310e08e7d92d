"""Files that join a site from elsewhere: pages of effects, and ready pages beside bare lessons."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

from sim.pages import effect_pages, lessons_only


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


def put_ready_pages(
    files: Files, config: MkDocsConfig, folder: Path, paths: Iterable[Path], names: Iterable[str]
) -> None:
    """Nothing of the lessons' folder stands at the root (banks hold keys): our pages do."""
    for file in [f for f in files if Path(f.abs_src_path or "/").resolve().is_relative_to(folder)]:
        files.remove(file)
    about = config.site_description or ""
    inside = {path.relative_to(folder).as_posix(): path for path in paths}
    lessons = {f"{folder.name}/{name}": path for name, path in inside.items()}
    for name in sorted(names):
        text = lessons_only.ready_page(name, config.site_name, about, lessons)
        if text is not None:
            files.append(File.generated(config, name, content=text))
