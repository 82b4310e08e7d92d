"""`carts run`: a scene, run exactly; or by a stepping method, to see what that makes of it."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import click

from sim.cli import scene_file
from sim.cli.progress import run_on_terminal
from sim.cli.tables import certificate_as_text, columns_as_csv, run_as_text
from sim.dynamics.loop.run import MOST_EVENTS
from sim.dynamics.report.document import report
from sim.dynamics.result.trajectory import trajectory
from sim.dynamics.stepping.methods import ADAPTIVE, NAMES
from sim.pages.findings import Finding

if TYPE_CHECKING:
    from sim.dynamics.stepping.recorded import SteppedRun
    from sim.scene import Scene

METHODS = ("exact", *NAMES)


@click.command("run")
@click.argument("scene", metavar="SCENE.yml")
@click.option(
    "--method",
    type=click.Choice(METHODS),
    default="exact",
    show_default=True,
    help="How to compute it; any other than exact holds for the whole run.",
)
@click.option(
    "--step",
    type=click.FloatRange(min=0, min_open=True),
    help="Step in s of a stepping method.  [default: 0.001]",
)
@click.option(
    "--rtol",
    type=click.FloatRange(min=1e-13, max=0.1),
    help="Relative tolerance of the methods rk45 and adaptive.  [default: 1e-9]",
)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object, for programs.")
@click.option("--csv", "as_csv", is_flag=True, help="Print the motion as columns: t, x, v, a, F.")
@click.option(
    "--max-events",
    type=click.IntRange(min=1),
    default=MOST_EVENTS,
    show_default=True,
    help="Stop after this many events.",
)
@click.option(
    "--certify",
    "certified",
    is_flag=True,
    help="Prove bounds of every event time and of the end, and the order of events.",
)
@click.option(
    "--world",
    metavar="NAME",
    help="Run it in an impossible world that the scene names under “worlds”.",
)
@click.option("--no-events", is_flag=True, help="Count events per kind instead of listing them.")
def command(
    scene: str,
    method: str,
    step: float | None,
    rtol: float | None,
    as_json: bool,
    as_csv: bool,
    max_events: int,
    no_events: bool,
    certified: bool,
    world: str | None,
) -> None:
    """Run a scene and say what happened.

    SCENE.yml is a scene file; - reads standard input.

    \b
    carts run my-scene.yml
    carts run my-scene.yml --method rk4 --step 0.01
    carts run my-scene.yml --json
    carts run my-scene.yml --certify
    carts run my-scene.yml --world bigger-pushes-more
    """
    if as_json and as_csv:
        raise click.UsageError("--json and --csv exclude each other.")
    if step is not None and method in ("exact", *ADAPTIVE):
        raise click.UsageError(f"--step does not go with --method {method}: it has no fixed step.")
    if rtol is not None and method not in ADAPTIVE:
        raise click.UsageError("--rtol goes with --method rk45 or adaptive.")
    if certified and (as_csv or method != "exact"):
        raise click.UsageError("--certify goes with the exact run, as text or with --json.")
    if world is not None:
        if certified or method != "exact":
            raise click.UsageError("--world goes with no method and no certificate.")
        _world(scene, world, as_json=as_json, as_csv=as_csv)
        return
    description = scene_file.read(scene)
    if description.written:
        if certified or method != "exact":
            raise click.UsageError("A law of your own goes with no method and no certificate.")
        _written(scene, description, as_json=as_json, as_csv=as_csv)
        return
    if method != "exact":
        result = _stepped(scene, description, method, step, rtol, keep_events=not no_events)
        _tell_stepped(result, method, as_json=as_json, as_csv=as_csv)
        return
    finished = run_on_terminal(
        scene,
        description,
        max_events=max_events,
        keep_events=not no_events,
        keep_motion=as_csv or not no_events,
    )
    certificate = _certificate(description) if certified else None
    if as_json:
        told = {**report(finished), "impossible": []}
        told |= {"certificate": certificate} if certificate else {}
        click.echo(json.dumps(told, allow_nan=False, ensure_ascii=False))
    elif as_csv:
        click.echo(columns_as_csv(trajectory(finished)), nl=False)
    else:
        click.echo(run_as_text(finished))
    if certificate is not None and not as_json:
        click.echo(f"\n{certificate_as_text(certificate)}")


def _world(name: str, wanted: str, *, as_json: bool, as_csv: bool) -> None:
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
        done = follow(fence.scene, world)
        found = broken(done)
    except UnsolvedError as error:
        place = scene_file.shown_name(name), 1, 1
        scene_file.fail([Finding(*place, "unsolved", error.message, error.hint)])
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


def _written(name: str, description: Scene, *, as_json: bool, as_csv: bool) -> None:
    """A scene whose contact names a law in a file."""
    from sim.dynamics.result.outcome import UnsolvedError
    from sim.mine.document import document
    from sim.mine.follow import follow
    from sim.mine.wrong import WrongLawError

    try:
        done = follow(description)
    except WrongLawError as error:
        scene_file.fail([Finding(error.file, error.line, 1, "law", error.message, error.hint)])
    except UnsolvedError as error:
        place = scene_file.shown_name(name), 1, 1
        scene_file.fail([Finding(*place, "unsolved", error.message, error.hint)])
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


def _certificate(description: Scene) -> dict[str, Any]:
    """Its JSON object."""
    from sim.certify.certificate import certify, document

    return document(certify(description))


def _tell_stepped(result: SteppedRun, method: str, *, as_json: bool, as_csv: bool) -> None:
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


def _stepped(
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
    from sim.dynamics.stepping.methods import MOST_STEPS, STEP, Way
    from sim.dynamics.stepping.recorded import stepped

    way = Way(method, rtol=rtol or RTOL) if method in ADAPTIVE else Way(method, step or STEP)
    if way.step and description.until / way.step > MOST_STEPS:
        raise click.UsageError(
            f"{description.until:g} s in steps of {way.step:g} s are more than {MOST_STEPS} steps. "
            "Choose a longer step, or an earlier end of the scene (until)."
        )
    try:
        return stepped(description, way, keep_events=keep_events)
    except UnsolvedError as error:
        place = scene_file.shown_name(name), 1, 1
        scene_file.fail([Finding(*place, "unsolved", error.message, error.hint)])
