"""`carts single`: one scene as one HTML file that opens anywhere, for a learning platform."""

from __future__ import annotations

from pathlib import Path

import click

from sim.cli.named_file import GivenFile
from sim.cli.scene_file import OF_LESSON, fail
from sim.cli.scene_of_lesson import LESSON, scene_in
from sim.cli.write_out import no_place, write_out
from sim.pages.findings import AuthorError, SiteError

SCENES = (".yml", ".yaml")
HERE = "Go to a folder that is yours, with room: for example in Documents."


@click.command("single")
@click.argument("name", metavar="PATH")
@click.option("--scene", "wanted", help="The id of the scene, where a lesson has several.")
@click.option(
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    help="The file to write (default: ID.html, here).",
)
def command(name: str, wanted: str | None, out: Path | None) -> None:
    """Write one scene as one HTML file of some 15 MB: picture, sliders, graphs and Python.

    PATH is a lesson (.md), LESSON.md#ID or a scene file (.yml).

    \b
    carts single worksheets/newtons-third-law.md --scene third-heavy-into-light
    carts single my-scene.yml --out collision.html
    """
    from sim.pages.single.of_scene import single_file

    of_lesson = OF_LESSON.fullmatch(name)
    if of_lesson and of_lesson["id"]:  # as `carts run` takes it
        name, wanted = of_lesson["lesson"], wanted or of_lesson["id"]
    path = GivenFile("a lesson or a scene file").convert(name, None, None)
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
    except OSError as error:  # Python is packed into a folder here before the page is written
        if refused := no_place(error, HERE):
            raise click.ClickException(refused) from None
        raise
    target = out or Path(f"{block.fence.id}.html")
    write_out(target, text, "--out FILE")
    click.echo(f"{target} ({target.stat().st_size / 1e6:.0f} MB). It needs no other file.")
