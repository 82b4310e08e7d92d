"""`carts run`: a scene, run exactly."""

from __future__ import annotations

import json

import click

from sim.cli import scene_file
from sim.cli.progress import run_on_terminal
from sim.cli.tables import columns_as_csv, run_as_text
from sim.dynamics.report import report
from sim.dynamics.run import MOST_EVENTS


@click.command("run")
@click.argument("scene", metavar="SCENE.yml")
@click.option("--method", type=click.Choice(["exact"]), default="exact", show_default=True)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object, for programs.")
@click.option("--csv", "as_csv", is_flag=True, help="Print the motion as columns: t, x, v, a, F.")
@click.option(
    "--max-events",
    type=click.IntRange(min=1),
    default=MOST_EVENTS,
    show_default=True,
    help="Stop after this many events.",
)
@click.option("--no-events", is_flag=True, help="Count events per kind instead of listing them.")
def command(
    scene: str, method: str, as_json: bool, as_csv: bool, max_events: int, no_events: bool
) -> None:
    """Run a scene and say what happened.

    SCENE.yml is a scene file; - reads standard input. Example:

        carts run tests/scenes/paper-two-carts.yml
    """
    if as_json and as_csv:
        raise click.UsageError("--json and --csv exclude each other.")
    description = scene_file.read(scene)
    finished = run_on_terminal(
        scene,
        description,
        max_events=max_events,
        keep_events=not no_events,
        keep_motion=as_csv or not no_events,
    )
    if as_json:
        click.echo(json.dumps(report(finished), allow_nan=False, ensure_ascii=False))
    elif as_csv:
        click.echo(columns_as_csv(finished), nl=False)
    else:
        click.echo(run_as_text(finished))
