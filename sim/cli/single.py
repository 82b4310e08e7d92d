"""`carts single`: one scene as one HTML file that opens anywhere, for a learning platform."""

from __future__ import annotations

from pathlib import Path

import click

from sim.cli.named_file import GivenFile
from sim.cli.scene_file import fail
from sim.cli.scene_of_lesson import LESSON, scene_in
from sim.cli.write_out import write_out
from sim.pages.findings import AuthorError, SiteError

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

    if path.suffix not in (LESSON, *SCENES):
        raise click.UsageError(
            f"{path} is neither a lesson (.md) nor a scene file (.yml): its ending tells which."
        )
    root = Path.cwd()
    try:
        block = scene_in(path, wanted, root, "--scene ")
        text = single_file(block, root, site_id="one-scene", report=click.echo)
    except AuthorError as error:
        fail(error.findings)
    except SiteError as error:
        raise click.ClickException(str(error)) from None
    target = out or Path(f"{block.fence.id}.html")
    write_out(target, text, "--out FILE")
    click.echo(f"{target} ({target.stat().st_size / 1e6:.0f} MB). It needs no other file.")
