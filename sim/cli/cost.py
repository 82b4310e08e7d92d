"""`carts cost`: what accuracy costs in time, method by method, on one scene."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import click

from sim.cli import scene_file
from sim.cli.tables import table
from sim.dynamics.cost.measure import CostRow, cost, ways
from sim.dynamics.cost.report import cost_report
from sim.dynamics.result.outcome import UnsolvedError
from sim.pages.drawing import DrawingError, draw
from sim.pages.findings import Finding
from sim.scene import Scene

HEADER = ("method", "step", "order", "evaluations", "time", "Δv m/s", "Δx m", "ΔE/E", "e delivered")


@click.command("cost")
@click.argument("scene", metavar="SCENE.yml")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object, for programs.")
@click.option(
    "--svg",
    "picture",
    type=click.Path(dir_okay=False, writable=True, path_type=Path),
    help="Write the figure, error against time, to this file.",
)
def command(scene: str, as_json: bool, picture: Path | None) -> None:
    """Compare stepping methods with the exact solution: error against time.

    SCENE.yml is a scene file; - reads standard input. `time` is the time of a single run as a
    multiple of the exact outcome's, measured in this process. Errors are the worst of 64 runs whose
    touches fall at different places within a step; steps are the run's length over a prime number.

    \b
    carts cost my-scene.yml
    carts cost my-scene.yml --svg cost.svg
    """
    description = scene_file.read(scene)
    try:
        rows = _measured(description)
    except UnsolvedError as error:
        place = scene_file.shown_name(scene), 1, 1
        scene_file.fail([Finding(*place, "unsolved", error.message, error.hint)])
    title = description.title or scene
    document = cost_report(title, rows)
    if picture is not None:
        try:
            drawn = draw("cost-file", {"title": title, "rows": document["rows"]})
        except DrawingError as error:
            raise click.ClickException(str(error)) from error
        picture.write_text(drawn, encoding="utf-8")
    if as_json:
        click.echo(json.dumps(document, allow_nan=False, ensure_ascii=False))
    else:
        click.echo(table(HEADER, [_cells(row, description.until) for row in rows]))
        if rows[0].error_v is None:
            click.echo("\nThe exact run is the reference: errors are measured against it.")


def _measured(scene: Scene) -> list[CostRow]:
    """All rows, with a line on the terminal that says how far it is."""
    rows, total, shown = [], len(ways(scene)) + 2, sys.stderr.isatty()
    for row in cost(scene):
        rows.append(row)
        if shown:
            sys.stderr.write(f"\r{len(rows)} of about {total} rows: {row.method:<16}")
            sys.stderr.flush()
    if shown:
        sys.stderr.write("\r" + " " * 60 + "\r")
    return rows


def _cells(row: CostRow, until: float) -> tuple[str, ...]:
    size = "–"
    if row.rtol is not None:
        size = f"rtol {row.rtol:.0e}".replace("-", "−")
    elif row.step is not None:
        size = f"{until:g} s/{round(until / row.step)}"
    delivered = "–"
    if row.delivered is not None:
        low, high = row.delivered
        delivered = f"{low:.6g}" if high - low < 5e-7 else f"{low:.4g} to {high:.4g}"
    return (
        row.method,
        size,
        "–" if row.order is None else str(row.order),
        str(row.evaluations),
        f"{row.time_ratio:.3g}" if row.time_ratio < 1000 else f"{row.time_ratio:.0f}",
        *(
            "–" if e is None else f"{e:.1e}".replace("-", "−")
            for e in (row.error_v, row.error_x, row.energy_error)
        ),
        delivered,
    )
