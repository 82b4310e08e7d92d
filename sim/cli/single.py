"""`carts single`: one scene as one HTML file that opens anywhere, for a learning platform."""

from __future__ import annotations

import json
import re
from pathlib import Path

import click

from sim.cli.named_file import GivenFile
from sim.cli.scene_file import fail
from sim.cli.site.site_folder import nearest_site
from sim.cli.write_out import write_out
from sim.pages.blocks.scene_block import Lesson, SceneBlock, SiteIds, read_scene_block
from sim.pages.findings import AuthorError, SiteError
from sim.pages.text.author_text import author_text
from sim.pages.text.fence_scan import scan
from sim.pages.text.lesson_places import LESSONS, bank_folders, scene_folders
from sim.pages.text.plain_lines import lines_of

SCENES = (".yml", ".yaml")


@click.command("single")
@click.argument("path", type=GivenFile("a lesson or a scene file"))
@click.option("--scene", "wanted", help="The id of the scene, where a lesson has several.")
@click.option(
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    help="The file to write (default: ID.html, here).",
)
def command(path: Path, wanted: str | None, out: Path | None) -> None:
    """Write one scene as one HTML file of some 15 MB: picture, sliders, graphs and Python.

    PATH is a lesson (.md) or a scene file (.yml).

    \b
    carts single worksheets/newtons-third-law.md --scene third-heavy-into-light
    carts single my-scene.yml --out collision.html
    """
    from sim.pages.single.of_scene import single_file

    if path.suffix not in (".md", *SCENES):
        raise click.UsageError(
            f"{path} is neither a lesson (.md) nor a scene file (.yml): its ending tells which."
        )
    root = Path.cwd()
    try:
        block = _scene(path, wanted, root)
        text = single_file(block, root, site_id="one-scene", report=click.echo)
    except AuthorError as error:
        fail(error.findings)
    except SiteError as error:
        raise click.ClickException(str(error)) from None
    target = out or Path(f"{block.fence.id}.html")
    write_out(target, text, "--out FILE")
    click.echo(f"{target} ({target.stat().st_size / 1e6:.0f} MB). It needs no other file.")


def _among_lessons(path: Path, root: Path) -> bool:
    """Whether a file lies in the folder of lessons of its site; `root`: where none is found."""
    site = nearest_site(path.parent) or root
    return path.is_relative_to(site / LESSONS)


def _scene(path: Path, wanted: str | None, root: Path) -> SceneBlock:
    """The scene that was meant; raises `AuthorError` for its mistakes."""
    path = path.resolve()
    shown = path.relative_to(root).as_posix() if path.is_relative_to(root) else path.name
    folders = (path.parent, *scene_folders(path, root))
    if path.suffix != ".md":
        name = re.sub(r"[^a-z0-9]+", "-", path.stem.lower()).strip("-") or "scene"
        lines = ["```scene", f"id: {name if name[0].isalpha() else f'scene-{name}'}"]
        lines += [f"file: {json.dumps(path.name, ensure_ascii=False)}", "```"]
    else:
        lines = lines_of(author_text(path, shown))
    # In a lesson a scene is watched first; so it is where it stands alone.
    watch = "first" if path.suffix == ".md" and _among_lessons(path, root) else ""
    lesson = Lesson(shown, folders, bank_folders(path, root), watch=watch)
    found = {}
    for block in scan(lines):
        if block.name == "scene":
            read = read_scene_block(block, lesson, SiteIds(), first_line=1)
            found[read.fence.id] = read
    if wanted is None and len(found) == 1:
        return next(iter(found.values()))
    if wanted in found:
        return found[str(wanted)]
    if not found:
        raise click.UsageError(f"There is no scene in {shown}.")
    raise click.UsageError(f"Name one scene of {shown}: --scene {' | '.join(found)}")
