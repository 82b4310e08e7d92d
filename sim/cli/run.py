"""`carts run`: a scene, run exactly; or by a stepping method, to see what that makes of it."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import click

from sim.cli import scene_file
from sim.cli.progress import run_on_terminal, still_computing
from sim.cli.run_otherwise import by_method, by_own_law, in_a_world, tell_stepped
from sim.cli.tables import certificate_as_text, columns_as_csv, run_as_text
from sim.cli.typed_options import typed
from sim.dynamics.loop.run import MOST_EVENTS
from sim.dynamics.report.document import report
from sim.dynamics.result.finished import Run
from sim.dynamics.result.trajectory import trajectory
from sim.dynamics.stepping.methods import ADAPTIVE, NAMES

if TYPE_CHECKING:
    from sim.scene import Scene

METHODS = ("exact", *NAMES)


@dataclass(frozen=True, slots=True, kw_only=True)
class Options:
    """As click hands them over; what each one means stands beside it at the command."""

    method: str
    step: float | None
    rtol: float | None
    as_json: bool
    as_csv: bool
    max_events: int
    no_events: bool
    certified: bool
    world: str | None

    @property
    def stepped(self) -> bool:
        """By a method, not exactly."""
        return self.method != "exact"

    def only_together(self) -> None:
        """Refuses options that exclude each other, whatever the scene."""
        if self.as_json and self.as_csv:
            raise click.UsageError("--json and --csv exclude each other.")
        if self.step is not None and self.method in ("exact", *ADAPTIVE):
            raise click.UsageError(
                f"--step does not go with --method {self.method}: it has no fixed step."
            )
        if self.rtol is not None and self.method not in ADAPTIVE:
            raise click.UsageError("--rtol goes with --method rk45 or adaptive.")
        if self.certified and (self.as_csv or self.stepped):
            raise click.UsageError("--certify goes with the exact run, as text or with --json.")
        if self.world is not None and (self.certified or self.stepped):
            raise click.UsageError("--world goes with no method and no certificate.")


@click.command("run")
@click.argument("scene", metavar="SCENE")
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
@click.pass_context
def command(ctx: click.Context, /, scene: str, **options: Any) -> None:
    """Run a scene and say what happened.

    SCENE is a scene file, or LESSON.md#ID of a lesson; - reads standard input.

    \b
    carts run my-scene.yml
    carts run my-scene.yml --method rk4 --step 0.01
    carts run my-scene.yml --json
    carts run my-scene.yml --certify
    carts run my-scene.yml --world bigger-pushes-more
    """
    wanted = Options(**options)
    wanted.only_together()
    as_json, as_csv = wanted.as_json, wanted.as_csv
    if wanted.world is not None:
        _no_others(ctx, ("max_events", "no_events"), "a world")
        in_a_world(scene, wanted.world, as_json=as_json, as_csv=as_csv)
        return
    description = scene_file.read(scene)
    if description.written:
        if wanted.certified or wanted.stepped:
            raise click.UsageError("A law of your own goes with no method and no certificate.")
        _no_others(ctx, ("max_events", "no_events"), "a law of your own")
        by_own_law(scene, description, as_json=as_json, as_csv=as_csv)
        return
    if wanted.stepped:
        _no_others(ctx, ("max_events",), "a stepping method")
        result = by_method(
            scene,
            description,
            wanted.method,
            wanted.step,
            wanted.rtol,
            keep_events=not wanted.no_events,
        )
        tell_stepped(result, wanted.method, as_json=as_json, as_csv=as_csv)
        return
    finished = run_on_terminal(
        scene,
        description,
        max_events=wanted.max_events,
        keep_events=not wanted.no_events,
        keep_motion=as_csv or not wanted.no_events,
    )
    certificate = _certificate(description) if wanted.certified else None
    if as_csv:
        click.echo(columns_as_csv(trajectory(finished)), nl=False)
    else:
        _tell(finished, certificate, as_json=as_json)


def _tell(finished: Run, certificate: dict[str, Any] | None, *, as_json: bool) -> None:
    if as_json:
        told = {**report(finished), "impossible": []}
        told |= {"certificate": certificate} if certificate else {}
        click.echo(json.dumps(told, allow_nan=False, ensure_ascii=False))
        return
    click.echo(run_as_text(finished))
    if certificate is not None:
        click.echo(f"\n{certificate_as_text(certificate)}")


def _no_others(ctx: click.Context, names: tuple[str, ...], what: str) -> None:
    """Refuses options that such a run has no use for."""
    for name in typed(ctx, names):
        raise click.UsageError(f"--{name.replace('_', '-')} does not go with {what}.")


def _certificate(description: Scene) -> dict[str, Any]:
    """Its JSON object."""
    from sim.certify.certificate import certify, document

    with still_computing():
        return document(certify(description))
