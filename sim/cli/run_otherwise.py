"""Runs of `carts run` beside the exact one: a world, a law of one's own, a stepping method."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import click

from sim.cli import scene_file
from sim.cli.progress import still_computing
from sim.cli.tables import columns_as_csv, run_as_text
from sim.dynamics.stepping.methods import ADAPTIVE
from sim.pages.findings import Finding

if TYPE_CHECKING:
    from sim.dynamics.stepping.recorded import SteppedRun
    from sim.scene import Scene


def in_a_world(name: str, wanted: str, *, as_json: bool, as_csv: bool) -> None:
    """The scene in a world that it names. Whatever is printed says that it is impossible."""
    from sim.dynamics.result.outcome import UnsolvedError
    from sim.worlds.breaks import broken
    from sim.worlds.document import document
    from sim.worlds.follow import follow

    fence = scene_file.read_shown(name)
    world = next((one for one in fence.worlds if one.kind.name == wanted), None)
    if world is None:
        raise click.UsageError(_not_named(wanted, [one.kind.name for one in fence.worlds]))
    try:
        with still_computing():
            done = follow(fence.scene, world)
            found = broken(done)
    except UnsolvedError as error:
        scene_file.unsolved(name, error)
    if as_json:
        click.echo(json.dumps(document(done, found), allow_nan=False, ensure_ascii=False))
        return
    label = f"Impossible: a world in which {world.kind.says}."
    if as_csv:
        click.echo(f"# {label}")
        click.echo(columns_as_csv(done.samples), nl=False)
        return
    click.echo(f"{label}\n\n{run_as_text(done.run)}\n")
    click.echo("\n".join(found.sentences))


def _not_named(wanted: str, named: list[str]) -> str:
    """Why a scene is not run in this world."""
    from sim.worlds.describe import kinds

    if wanted not in kinds():
        return f"There is no world “{wanted}”. Worlds: {', '.join(kinds())}"
    return (
        f"The scene does not name the world “{wanted}” (it names {', '.join(named) or 'none'}). "
        f"Write in it: worlds: [{wanted}]"
    )


def by_own_law(name: str, description: Scene, *, as_json: bool, as_csv: bool) -> None:
    """A scene whose contact names a law in a file."""
    from sim.dynamics.result.outcome import UnsolvedError
    from sim.mine.document import document
    from sim.mine.follow import follow
    from sim.mine.wrong import WrongLawError

    try:
        with still_computing():
            done = follow(description)
    except WrongLawError as error:
        scene_file.fail([Finding(error.file, error.line, 1, "law", error.message, error.hint)])
    except UnsolvedError as error:
        scene_file.unsolved(name, error)
    if as_json:
        told = {**document(done), "impossible": []}
        click.echo(json.dumps(told, allow_nan=False, ensure_ascii=False))
    elif as_csv:
        click.echo(columns_as_csv(done.samples), nl=False)
    else:
        click.echo(run_as_text(done.run))
        click.echo(f"\nWith {', '.join(description.written)}, asked {done.calls} times.")
        if done.unequal:
            click.echo("The two sides were not answered alike: see carts law.")


def tell_stepped(result: SteppedRun, method: str, *, as_json: bool, as_csv: bool) -> None:
    """A run by a stepping method, and what it lost."""
    from sim.dynamics.stepping.stepped_report import stepped_report

    if as_json:
        click.echo(json.dumps(stepped_report(result), allow_nan=False, ensure_ascii=False))
    elif as_csv:
        click.echo(columns_as_csv(result.samples), nl=False)
    else:
        click.echo(run_as_text(result.run))
        click.echo(
            f"\nStepped with {method}: {result.steps} steps, {result.evaluations} evaluations. "
            f"Not accounted for: {result.lost_energy:.3g} J, {result.lost_momentum:.3g} N s."
        )


def by_method(
    name: str,
    description: Scene,
    method: str,
    step: float | None,
    rtol: float | None,
    *,
    keep_events: bool,
) -> SteppedRun:
    """The run by a stepping method; what it cannot do goes to standard error."""
    from sim.dynamics.result.outcome import UnsolvedError
    from sim.dynamics.stepping.adaptive_events import RTOL
    from sim.dynamics.stepping.methods import MOST_STEPS, STEP, MethodChoice
    from sim.dynamics.stepping.recorded import stepped

    choice = (
        MethodChoice(method, rtol=rtol or RTOL)
        if method in ADAPTIVE
        else MethodChoice(method, step or STEP)
    )
    if choice.step and description.until / choice.step > MOST_STEPS:
        raise click.UsageError(
            f"{description.until:g} s in steps of {choice.step:g} s are more than {MOST_STEPS} "
            "steps. Choose a longer step, or an earlier end of the scene (until)."
        )
    try:
        with still_computing():
            return stepped(description, choice, keep_events=keep_events)
    except UnsolvedError as error:
        scene_file.unsolved(name, error)
