"""`carts cost`: what accuracy costs in time, method by method, on one scene."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from pathlib import Path

import click

from sim.cli import scene_file
from sim.cli.progress import line, still_computing
from sim.cli.proved import proved
from sim.cli.tables import table
from sim.cli.write_out import write_out
from sim.dynamics.cost.exact import Exact, exact
from sim.dynamics.cost.many import event_cost
from sim.dynamics.cost.measure import CostRow, NotRun, choices, cost
from sim.dynamics.cost.report import cost_report
from sim.dynamics.report.document import FORMAT
from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.stepping.methods import MethodChoice
from sim.pages.drawing import DrawingError, draw
from sim.scene import Scene

MOST_CARTS = 10_000
ENDLESS = "∞"  # an error beyond all numbers
DRAWN = ("rows", "floor", "digits")  # of the document, in the figure
DIGITS = {"digits": "", "digits_x": "of x (the carts end at rest) "}
HEADER = ("method", "step", "order", "evaluations", "time", "Δv m/s", "Δx m", "ΔE/E", "e delivered")


@click.command("cost")
@click.argument("scene", metavar="SCENE", required=False)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object, for programs.")
@click.option(
    "--svg",
    "picture",
    type=click.Path(dir_okay=False, writable=True, path_type=Path),
    help="Write the figure, error against time, to this file.",
)
@click.option(
    "--carts",
    metavar="N,N,...",
    help="In place of a scene: what one event costs in a row of so many carts, up to 10000.",
)
def command(scene: str | None, as_json: bool, picture: Path | None, carts: str | None) -> None:
    """Compare stepping methods with the exact solution: error against time.

    SCENE is a scene file, or LESSON.md#ID of a lesson; - reads standard input. `time` is the time
    of a single run as a multiple of the exact outcome's, measured in this process. Errors are the
    worst of up to 64 runs whose touches fall at different places within a step.
    With python-flint (pip install "newtons-carts[certify]") errors are measured against a proof,
    where there is one; that has half of its width as error.

    \b
    carts cost my-scene.yml
    carts cost my-scene.yml --svg cost.svg
    carts cost --carts 2,10,100,1000,10000
    """
    if carts is not None:
        if scene is not None or picture is not None:
            raise click.UsageError("--carts stands in place of a scene, and has no --svg.")
        _events(_counts(carts), as_json)
        return
    if scene is None:
        raise click.UsageError("Name a scene file, or say --carts.")
    description = scene_file.read(scene)
    try:
        truth, rows, not_run = _measured(description)
    except UnsolvedError as error:
        scene_file.unsolved(scene, error)
    title = description.title or scene
    document = cost_report(title, rows, truth, not_run)
    if picture is not None:
        try:
            drawn = draw("cost-file", {"title": title, **{k: document[k] for k in DRAWN}})
        except DrawingError as error:
            raise click.ClickException(str(error)) from error
        write_out(picture, drawn, "--svg FILE")
    if as_json:
        click.echo(json.dumps(document, allow_nan=False, ensure_ascii=False))
    else:
        click.echo(_table(rows, not_run, description.until))
        click.echo("")
        if any(math.inf in (row.error_v, row.error_x, row.energy_error) for row in rows):
            click.echo(f"{ENDLESS}: the method blew up, its numbers grew beyond all bounds.")
        for key, what in DIGITS.items():
            if digits := document.get(key):
                each = ", ".join(f"{method} × {by:.3g}" for method, by in digits.items())
                click.echo(f"One more digit {what}costs: {each}")
        if truth.proved:
            click.echo("Errors are measured against a proof: carts run --certify.")
        elif rows[0].error_v is None:
            click.echo("The exact run is the reference: errors are measured against it.")


def _measured(scene: Scene) -> tuple[Exact, list[CostRow], list[NotRun]]:
    """The truth, all rows and what cannot be run, with a line that says how far it is."""
    rows, not_run, total = list[CostRow](), list[NotRun](), len(choices(scene)) + 3
    with still_computing(), line() as write:
        truth = exact(scene)
        certified = proved(scene, truth)
        if certified:
            truth, _ = certified
        for row in cost(scene, truth):
            if isinstance(row, NotRun):
                not_run.append(row)
            else:
                rows.append(row)
            if write:
                method = row.choice.method if isinstance(row, NotRun) else row.method
                write(f"{len(rows) + len(not_run)} of about {total} rows: {method}")
    if certified:
        rows.insert(sum(row.method.startswith("exact") for row in rows), certified[1])
    return truth, rows, not_run


def _counts(text: str) -> list[int]:
    """How many carts, one after the other."""
    try:
        counts = [int(one) for one in text.split(",")]
    except ValueError:
        counts = [0]
    if not all(2 <= count <= MOST_CARTS for count in counts):
        raise click.BadParameter(f"numbers from 2 to {MOST_CARTS}, such as 2,10,100", None, None)
    return counts


def _events(counts: list[int], as_json: bool) -> None:
    """What one event costs in rows of so many carts, in this process."""
    found = [event_cost(count) for count in counts]
    base = found[0].seconds
    if as_json:
        rows = [{"carts": one.carts, "events": one.events, "seconds": one.seconds} for one in found]
        click.echo(json.dumps({"format": FORMAT, "rows": rows}, allow_nan=False))
        return
    lines = [
        (str(one.carts), str(one.events), f"{1e6 * one.seconds:.1f}", f"{one.seconds / base:.2f}")
        for one in found
    ]
    click.echo(table(("carts", "events", "µs each", "ratio"), lines))


def _table(rows: Sequence[CostRow], not_run: Sequence[NotRun], until: float) -> str:
    """The rows; and in one more column why a method has no numbers, where there is such a one."""
    cells = [_cells(row, until) for row in rows]
    if not not_run:
        return table(HEADER, cells)
    nothing = ("–",) * (len(HEADER) - 2)
    left = [(one.choice.method, _size(one.choice, until), *nothing, one.reason) for one in not_run]
    return table((*HEADER, "cannot run it"), [*((*row, "") for row in cells), *left])


def _size(of: CostRow | MethodChoice, until: float) -> str:
    if of.rtol is not None:
        return f"rtol {of.rtol:.0e}".replace("-", "−")
    return "–" if of.step is None else f"{until:g} s/{round(until / of.step)}"


def _cells(row: CostRow, until: float) -> tuple[str, ...]:
    delivered = "–"
    if row.delivered is not None:
        low, high = row.delivered
        delivered = f"{low:.6g}" if high - low < 5e-7 else f"{low:.4g} to {high:.4g}"
        delivered = delivered.replace("-", "−")
    return (
        row.method,
        _size(row, until),
        "–" if row.order is None else str(row.order),
        str(row.evaluations),
        f"{row.time_ratio:.3g}" if row.time_ratio < 1000 else f"{row.time_ratio:.0f}",
        *(
            "–" if e is None else f"{e:.1e}".replace("-", "−").replace("inf", ENDLESS)
            for e in (row.error_v, row.error_x, row.energy_error)
        ),
        delivered,
    )
