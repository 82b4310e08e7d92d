"""`carts plan`: which solver takes which phase, and why."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import click

from sim.cli import scene_file
from sim.cli.progress import run_on_terminal, still_computing
from sim.cli.tables import table
from sim.dynamics.report.document import finite, phase_object
from sim.dynamics.report.plan import not_simulated, plan
from sim.dynamics.result.outcome import UnsolvedError
from sim.scene.said import capital

if TYPE_CHECKING:
    from sim.scene import Scene


@click.command("plan")
@click.argument("scene", metavar="SCENE")
@click.option("--json", "as_json", is_flag=True, help="Print a JSON list.")
@click.option(
    "--relevance",
    is_flag=True,
    help="Say what each effect changes, or would change, by running the scene with and without.",
)
def command(scene: str, as_json: bool, relevance: bool) -> None:
    """Say how a scene would be solved, phase by phase, and why.

    SCENE is a scene file, or LESSON.md#ID of a lesson; - reads standard input.

    \b
    carts plan my-scene.yml
    carts plan --json my-scene.yml
    carts plan --relevance my-scene.yml
    """
    description = scene_file.read(scene)
    if description.written:
        if relevance:
            raise click.UsageError("--relevance does not go with a law of your own.")
        _written(description, as_json=as_json)
        return
    if relevance:
        _relevance(scene, description, as_json=as_json)
        return
    phases = plan(run_on_terminal(scene, description))
    if as_json:
        click.echo(json.dumps(finite([phase_object(p) for p in phases]), ensure_ascii=False))
        return
    rows = [(f"{p.begin:.6g}", f"{p.until:.6g}", str(p.tier), p.solver, p.why) for p in phases]
    click.echo(table(("from s", "until s", "tier", "solver", "why"), rows))
    left_out = not_simulated(description)
    if left_out:
        click.echo(f"\nNot simulated: {', '.join(left_out)}.")


def _written(description: Scene, *, as_json: bool) -> None:
    """A law in a file: one solver for the whole run, whatever happens in it."""
    from sim.mine.document import plan_of

    (phase,) = phases = plan_of(description)
    if as_json:
        click.echo(json.dumps(phases, ensure_ascii=False))
        return
    row = (f"{phase[key]:.6g}" for key in ("from", "until"))
    cells = (*row, str(phase["tier"]), phase["solver"], phase["why"])
    click.echo(table(("from s", "until s", "tier", "solver", "why"), [cells]))


def _relevance(name: str, description: Scene, *, as_json: bool) -> None:
    """The ladder: largest first, with the reading accuracy of a graph as the line."""
    from sim.dynamics.relevance.difference import READS
    from sim.dynamics.relevance.ranking import ranked_effects, rows

    try:
        with still_computing():
            ranked = ranked_effects(description)
    except UnsolvedError as error:
        scene_file.unsolved(name, error)
    if as_json:
        click.echo(json.dumps(finite(rows(ranked)), ensure_ascii=False))
        return
    line = f"---- a graph shows {100 * READS:g} % of its height, and nothing below ----"
    drawn = False
    for one in ranked:
        if not one.visible and not drawn:
            click.echo(line)
            drawn = True
        source = f" [{one.candidate.source}]" if one.candidate.source else ""
        click.echo(f"{capital(one.sentence)}{source}")
