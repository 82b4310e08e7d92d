"""One scene of a lesson, or of a scene file, as it stands in a page."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path

import click

from sim.cli.site.site_folder import nearest_site
from sim.pages.blocks.scene_block import Lesson, SceneBlock, SiteIds, read_scene_block
from sim.pages.text.author_text import author_text
from sim.pages.text.fence_scan import scan
from sim.pages.text.lesson_places import LESSONS, bank_folders, scene_folders
from sim.pages.text.plain_lines import lines_of

LESSON = ".md"


def scene_in(
    path: Path,
    wanted: str | None,
    root: Path,
    naming: str,
    laws: Mapping[str, str] | None = None,
) -> SceneBlock:
    """The scene that was meant; raises `AuthorError` for its mistakes. `naming`: what a command has
    before the id of one of several; `laws`: texts of laws that need no file beside it."""
    path = path.resolve()
    shown = path.relative_to(root).as_posix() if path.is_relative_to(root) else path.name
    folders = (path.parent, *scene_folders(path, root))
    if path.suffix != LESSON:
        name = re.sub(r"[^a-z0-9]+", "-", path.stem.lower()).strip("-") or "scene"
        lines = ["```scene", f"id: {name if name[0].isalpha() else f'scene-{name}'}"]
        lines += [f"file: {json.dumps(path.name, ensure_ascii=False)}", "```"]
    else:
        lines = lines_of(author_text(path, shown))
    # In a lesson a scene is watched first; so it is where it stands alone.
    watch = "first" if path.suffix == LESSON and _among_lessons(path, root) else ""
    lesson = Lesson(shown, folders, bank_folders(path, root), watch=watch)
    found = {}
    for block in scan(lines):
        if block.name == "scene":
            read = read_scene_block(block, lesson, SiteIds(), first_line=1, laws=laws)
            found[read.fence.id] = read
    if wanted is None and len(found) == 1:
        return next(iter(found.values()))
    if wanted in found:
        return found[str(wanted)]
    if not found:
        raise click.UsageError(f"There is no scene in {shown}.")
    missing = f"There is no scene “{wanted}” here. " if wanted else ""
    raise click.UsageError(f"{missing}Name one scene of {shown}: {naming}{' | '.join(found)}")


def _among_lessons(path: Path, root: Path) -> bool:
    """Whether a file lies in the folder of lessons of its site; `root`: where none is found."""
    site = nearest_site(path.parent) or root
    return path.is_relative_to(site / LESSONS)
