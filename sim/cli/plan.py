"""`carts plan`: which solver takes which phase, and why."""

from __future__ import annotations

import json

import click

from sim.cli import scene_file
from sim.cli.progress import run_on_terminal
from sim.cli.tables import table
from sim.dynamics.report.document import finite, phase_object
from sim.dynamics.report.plan import not_simulated, plan


@click.command("plan")
@click.argument("scene", metavar="SCENE.yml")
@click.option("--json", "as_json", is_flag=True, help="Print the phases as a JSON list.")
def command(scene: str, as_json: bool) -> None:
    """Say how a scene would be solved, phase by phase, and why.

    SCENE.yml is a scene file; - reads standard input.

    \b
    carts plan my-scene.yml
    carts plan --json my-scene.yml
    """
    description = scene_file.read(scene)
    phases = plan(run_on_terminal(scene, description))
    if as_json:
        click.echo(json.dumps(finite([phase_object(p) for p in phases]), ensure_ascii=False))
        return
    rows = [(f"{p.begin:.6g}", f"{p.until:.6g}", str(p.tier), p.solver, p.why) for p in phases]
    click.echo(table(("from s", "until s", "tier", "solver", "why"), rows))
    left_out = not_simulated(description)
    if left_out:
        click.echo(f"\nNot simulated: {', '.join(left_out)}.")
