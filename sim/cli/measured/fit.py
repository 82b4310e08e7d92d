"""`carts fit`: what a class's own carts did, from films, motion capture, sensors or phones."""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, NoReturn

import click

from sim.cli.measured.cart_options import quantity
from sim.cli.measured.options import Options
from sim.cli.measured.printed import ladder, strip
from sim.cli.measured.reading_files import cut, needs_scipy, readings
from sim.cli.measured.units_said import units_said, warn_of_assumed
from sim.cli.measured.unused import OF_UNITS, only_of_positions, warn_of_model, warn_of_units
from sim.cli.tables import table
from sim.cli.typed_options import typed
from sim.cli.write_out import write_out
from sim.measured.analysis import Analysis, analysed
from sim.measured.refusal import FitError
from sim.measured.report import forces_report, model_as_tracker
from sim.measured.third_law import third_law
from sim.measured.tracks import Measured
from sim.measured.units import OFFERED
from sim.scene.quantity import TIME

FILE = click.Path(dir_okay=False, path_type=Path)


@click.command("fit")
@click.argument("files", nargs=-1, required=True)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object, for programs.")
@click.option(
    "--law",
    type=click.Choice(["bumper", "paper"]),
    default="bumper",
    show_default=True,
    help="Which contact law the overlap follows while the carts touch.",
)
@click.option(
    "--friction",
    is_flag=True,
    help="Fit a deceleration of each cart by friction, even if the readings do not call for it.",
)
@click.option("--tilt", is_flag=True, help="Fit the tilt of the track, called for or not.")
@click.option(
    "--contact", metavar="TIME", help="Of several contacts, take the one nearest to this time."
)
@click.option("--segment", "spans", multiple=True, metavar="KIND=FROM..UNTIL",
              help="What happened then: rest, hand, coasting, friction, contact or stop; NAME:KIND "
              "of one cart. Example: contact=1.20..1.34")  # fmt: skip
@click.option(
    "--flip",
    "flips",
    multiple=True,
    metavar="NAME",
    help="This sensor counts the other way round: its readings change their sign.",
)
@click.option(
    "--zero",
    "zeros",
    multiple=True,
    metavar="NAME=LENGTH",
    help="What this sensor reads at the place that is to be 0.",
)
@click.option(
    "--mass",
    "masses",
    multiple=True,
    metavar="NAME=MASS",
    help="A weighed cart: then k and the other mass are printed. Twice: momentum is compared too.",
)
@click.option(
    "--touch",
    metavar="LENGTH",
    help="Distance of the two marks when the bumpers just touch, for example 21.5 cm.",
)
@click.option("--together", is_flag=True, help="You saw that the carts stayed together: where a "
              "sensor lost one of them, the other one tells its velocity.")  # fmt: skip
@click.option("--run", metavar="NUMBER", default="",
              help="Of several runs in a log, this one; default: the first.")  # fmt: skip
@click.option("--from", "begin", metavar="TIME", help="Leave readings before this time out.")
@click.option("--until", "end", metavar="TIME", help="Leave readings after this time out.")
@click.option("--length", type=click.Choice(OFFERED["length"]), default="m", show_default=True,
              help="Unit of positions, where the file names none.")  # fmt: skip
@click.option("--time", type=click.Choice(OFFERED["time"]), default="s", show_default=True,
              help="Unit of times, where the file names none.")  # fmt: skip
@click.option("--force", type=click.Choice(OFFERED["force"]), default="N", show_default=True,
              help="Unit of forces, where the file names none.")  # fmt: skip
@click.option("--scene", "scene_file", type=FILE, help="Write the fitted scene to this file.")
@click.option("--tracker", "tracker_file", type=FILE,
              help="Write the model's run to this file, as Tracker's text.")  # fmt: skip
@click.pass_context
def command(ctx: click.Context, /, files: tuple[str, ...], **options: Any) -> None:
    """Fit the model to the motion of two real carts, or compare two force sensors.

    FILES: one file with the readings of both carts, or one for each; - reads standard input.
    Tracker's export and projects (.trk), motion capture (TSV of Qualisys, CSV of OptiTrack and
    Vicon), logs of sensor carts, phyphox's CSV (zipped too) and any CSV are read as they are. What
    happened is found first (rest, hand, coasting, contact, stop), then what the contact was: a
    bounce, a stick or an explosion. Every number is printed with its 95 % interval; what the
    readings cannot tell is not printed, and readings that tell nothing are refused with the reason.

    \b
    carts fit two-carts.csv
    carts fit left.txt right.txt --mass A="0.5 kg" --scene fitted.yml
    """
    chosen = Options(**options)
    measured = _read(ctx, files, chosen)
    wanted = chosen.wanted(measured.names)
    found = analysed(measured, wanted) if measured.kind == "length" else None
    report = found.report if found else _forces(files[0], measured)
    _write(ctx, found, chosen.scene_file, chosen.tracker_file)
    above = strip(found.story.segments, measured.names) if found and not chosen.as_json else []
    click.echo(_as_json(report) if chosen.as_json else _as_text(report, above))
    if found and found.refused:
        _fail(f"{files[0]}: error: {found.refused.reason}", found.refused.hint)
    written = () if chosen.as_json else (chosen.scene_file, chosen.tracker_file)
    for path in filter(None, written):
        click.echo(f"Written: {path}")


def _read(ctx: click.Context, files: tuple[str, ...], chosen: Options) -> Measured:
    """The readings between two times, with what is said of their units."""
    if len(files) > 2:
        raise click.UsageError("One file with both carts, or two files with one cart each.")
    needs_scipy()
    begin, end = quantity("--from", chosen.begin, TIME), quantity("--until", chosen.end, TIME)
    if begin is not None and end is not None and begin >= end:
        raise click.UsageError(f"--from {chosen.begin} is not before --until {chosen.end}.")
    measured = cut(readings(files, chosen.units), begin, end)
    only_of_positions(ctx, measured.kind)
    warn_of_units(ctx, measured)
    given = typed(ctx, OF_UNITS)
    warn_of_assumed(measured, given)
    notes = units_said(measured.assumed, chosen.units, given)
    return replace(measured, notes=(*notes, *measured.notes))


def _write(
    ctx: click.Context, found: Analysis | None, scene_file: Path | None, tracker_file: Path | None
) -> None:
    """Writes the files of a bounce that are asked for; where there was none, what only it has is
    warned of or refused."""
    made, refused = (found.fit, found.refused) if found else (None, None)
    if found and not made and not refused:
        warn_of_model(ctx)
    if made is None and (scene_file or tracker_file) and not refused:
        raise click.UsageError("--scene and --tracker need a bounce, seen in positions.")
    if scene_file and found and made:
        write_out(scene_file, found.report["scene"], "--scene FILE")
    if tracker_file and found and made:
        write_out(tracker_file, model_as_tracker(found.story.measured, made), "--tracker FILE")


def _forces(name: str, measured: Measured) -> dict[str, Any]:
    try:
        return forces_report(measured, third_law(measured))
    except FitError as error:
        _fail(f"{name}: error: {error.reason}", error.hint)


def _fail(reason: str, hint: str) -> NoReturn:
    click.echo(reason + (f"\n  hint: {hint}" if hint else ""), err=True)
    sys.exit(1)


def _as_json(report: dict[str, Any]) -> str:
    return json.dumps(report, ensure_ascii=False, allow_nan=False)


def _not_printed(untold: Sequence[dict[str, str]]) -> list[str]:
    """One line for each reason: what one cause hides is told together."""
    names: dict[str, list[str]] = {}
    for one in untold:
        names.setdefault(one["reason"], []).append(one["name"])
    return [f"Not printed: {'; '.join(hidden)}: {reason}." for reason, hidden in names.items()]


def _as_text(report: dict[str, Any], strip_lines: list[str]) -> str:
    names, counts = report["names"], report["readings"]
    head = ", ".join(f"{name}: {n} readings" for name, n in zip(names, counts, strict=True))
    lines = [f"{head}; {'; '.join(report['read'])}", ""]
    lines += [*strip_lines, ""] if strip_lines else []
    if report["kind"] == "motion" and report["known"]:
        above = (f"Fitted with {report['law_words']}.", report["added"], report["doubt"])
        lines += [*filter(None, above), ""]
        rows = [(one["name"], one["interval"]) for one in report["known"]]
        lines += [table(("what", "value ± half of the 95 % interval"), rows), ""]
        lines += _not_printed(report["untold"])
        lines.append("")
    others = len(report.get("contacts", ())) > 1
    said = [*report["sentences"], *(["--contact TIME chooses another contact."] if others else ())]
    return "\n".join([*lines, *said, *ladder(report.get("rungs"))])
