"""`carts fit`: what a class's own carts did, from Tracker's export or two force sensors."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any, NoReturn, cast

import click

from sim.cli.tables import table
from sim.measured.cells import MOST_BYTES, decoded
from sim.measured.effects import compare
from sim.measured.fit import Asked, Effect, Fit, fit
from sim.measured.refusal import FitError, ReadingError
from sim.measured.report import forces_report, model_as_tracker, motion_report
from sim.measured.third_law import third_law
from sim.measured.tracks import Measured, between, read_measured
from sim.measured.units import OFFERED, Units
from sim.scene.quantity import LENGTH, MASS, TIME, Dimension, QuantityError, read_quantity

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
@click.option("--friction", is_flag=True, help="Fit a deceleration of each cart by friction too.")
@click.option("--tilt", is_flag=True, help="Fit the tilt of the track too.")
@click.option(
    "--mass",
    "masses",
    multiple=True,
    metavar="NAME=MASS",
    help="A weighed cart: then k and the other mass are printed. Twice: both are compared.",
)
@click.option(
    "--touch",
    metavar="LENGTH",
    help="Distance of the two marks when the bumpers just touch, for example 21.5 cm.",
)
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
def command(
    ctx: click.Context,
    files: tuple[str, ...],
    as_json: bool,
    law: str,
    friction: bool,
    tilt: bool,
    masses: tuple[str, ...],
    touch: str | None,
    begin: str | None,
    end: str | None,
    length: str,
    time: str,
    force: str,
    scene_file: Path | None,
    tracker_file: Path | None,
) -> None:
    """Fit the model to the motion of two real carts, or compare two force sensors.

    FILES: one text with the readings of both carts, or one for each; - reads standard input.
    Tracker's export, CSV and sensor logs are read as they are: tab, semicolon, comma or spaces,
    decimal point or comma. Every number is printed with its 95 % interval; what the readings
    cannot tell is not printed.

    \b
    carts fit two-carts.csv
    carts fit left.txt right.txt --mass A="0.5 kg" --scene fitted.yml
    """
    if len(files) > 2:
        raise click.UsageError("One file with both carts, or two files with one cart each.")
    if friction and tilt:
        raise click.UsageError("--friction or --tilt: one film does not tell both apart.")
    units = Units(time=time, length=length, force=force)
    measured = _read(files, units)
    measured = _cut(measured, _quantity("--from", begin, TIME), _quantity("--until", end, TIME))
    try:
        if measured.kind == "force":
            report: dict[str, Any] = forces_report(measured, third_law(measured))
            made = None
        else:
            made, report = _fitted(measured, law, friction, tilt, touch, masses)
    except FitError as error:
        _fail(f"{files[0]}: error: {error.reason}", error.hint)
    if made is None and (scene_file or tracker_file):
        raise click.UsageError("--scene and --tracker need positions, not forces.")
    if scene_file:
        scene_file.write_text(report["scene"], encoding="utf-8")
    if tracker_file and made:
        tracker_file.write_text(model_as_tracker(measured, made), encoding="utf-8")
    if as_json:
        click.echo(json.dumps(report, ensure_ascii=False, allow_nan=False))
        return
    click.echo(_as_text(report))
    for path in filter(None, (scene_file, tracker_file)):
        click.echo(f"Written: {path}")


def _fitted(
    measured: Measured, law: str, friction: bool, tilt: bool, touch: str | None,
    masses: tuple[str, ...],
) -> tuple[Fit, dict[str, Any]]:  # fmt: skip
    effect: Effect = "friction" if friction else "tilt" if tilt else "none"
    asked = Asked(law=cast(Any, law), distance=_quantity("--touch", touch, LENGTH))
    weighed = _weighed(masses, measured.names)
    plain = fit(measured, asked)
    compared = compare(measured, plain)
    made = next((row.fit for row in compared if row.effect == effect), None)
    if made is None:
        raise FitError(f"the fit with {effect} finds no values", "try without it")
    return made, motion_report(measured, made, compared, weighed)


def _read(files: tuple[str, ...], units: Units) -> Measured:
    """The readings; what is wrong with a file goes to standard error, and the command ends."""
    texts = []
    for name in files:
        try:
            texts.append(decoded(_bytes(name)))
        except ReadingError as error:
            _refuse(name, error)
    try:
        return read_measured(texts, units)
    except ReadingError as error:
        _refuse(files[error.source], error)


def _refuse(name: str, error: ReadingError) -> NoReturn:
    for fault in error.faults:
        hint = f"\n  hint: {fault.hint}" if fault.hint else ""
        click.echo(f"{name}:{fault.line}:1: error: {fault.reason}{hint}", err=True)
    sys.exit(1)


def _fail(reason: str, hint: str) -> NoReturn:
    click.echo(reason + (f"\n  hint: {hint}" if hint else ""), err=True)
    sys.exit(1)


def _cut(measured: Measured, begin: float | None, end: float | None) -> Measured:
    if begin is None and end is None:
        return measured
    try:
        return between(measured, begin, end)
    except ReadingError as error:
        _refuse("--from/--until", error)


def _bytes(name: str) -> bytes:
    """Raises click's usage error: a wrong path is a wrong call."""
    if name == "-":
        return sys.stdin.buffer.read(MOST_BYTES + 1)
    try:
        with Path(name).open("rb") as file:
            return file.read(MOST_BYTES + 1)
    except FileNotFoundError:
        raise click.UsageError(f"There is no file “{name}”.") from None
    except IsADirectoryError:
        raise click.UsageError(f"“{name}” is a folder, not a file of readings.") from None
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or error
        raise click.UsageError(f"“{name}” cannot be read: {why}.") from None


def _quantity(option: str, text: str | None, dimension: Dimension) -> float | None:
    if text is None:
        return None
    try:
        return float(read_quantity(text, dimension))
    except QuantityError as error:
        raise click.UsageError(f"{option} {text}: {error.message}; {error.hint}.") from None


def _weighed(texts: tuple[str, ...], names: tuple[str, str]) -> dict[str, float]:
    found: dict[str, float] = {}
    for text in texts:
        name, equals, value = text.partition("=")
        mass = _quantity("--mass", value, MASS) if equals else None
        if mass is None:
            raise click.UsageError(f"--mass {text}: write NAME=MASS, for example A=0.5kg.")
        if mass <= 0.0:
            raise click.UsageError(f"--mass {text}: a mass is more than 0.")
        name = name.strip()
        if name not in names:
            known = " and ".join(names)
            raise click.UsageError(f"--mass {text}: there is no cart “{name}”; there are {known}.")
        found[name] = mass
    return found


def _as_text(report: dict[str, Any]) -> str:
    names, counts = report["names"], report["readings"]
    head = ", ".join(f"{name}: {n} readings" for name, n in zip(names, counts, strict=True))
    lines = [f"{head}; {'; '.join(report['read'])}", ""]
    if report["kind"] == "motion":
        lines += [f"Fitted with {report['law_words']}.", ""]
        rows = [(one["name"], one["text"].removeprefix(f"{one['name']}: ")) for one in
                report["known"]]  # fmt: skip
        lines += [table(("what", "value ± half of the 95 % interval"), rows), ""]
        lines += [f"Not printed: {one['name']}: {one['reason']}." for one in report["untold"]]
        lines.append("")
    return "\n".join([*lines, *report["sentences"]])
