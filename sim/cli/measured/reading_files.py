"""The files of readings that a command is given; what is wrong with one goes to standard error."""

from __future__ import annotations

import sys
from importlib.util import find_spec
from typing import NoReturn

import click

from sim.cli.named_file import bytes_of
from sim.measured.refusal import ReadingError
from sim.measured.sheet.runs import run_place
from sim.measured.tracks import Measured, between, read_measured
from sim.measured.units import Units
from sim.measured.zipped import MOST_ZIPPED, texts_of


def needs_scipy() -> None:
    """Ends the command with what to do, where a fit has nothing to be made with."""
    if find_spec("scipy") is None:
        click.echo(
            "error: carts fit needs the Python package scipy, and it is not here\n"
            "  hint: python -m pip install scipy. The page in the browser brings its own",
            err=True,
        )
        sys.exit(1)


def readings(files: tuple[str, ...], units: Units) -> Measured:
    """The readings; what is wrong with a file goes to standard error, and the command ends."""
    texts = []
    for name in files:
        try:
            texts += texts_of(bytes_of(name, MOST_ZIPPED + 1, "a file of readings"))
        except ReadingError as error:
            _refuse(name, error)
    try:
        measured = read_measured(texts, units)
    except ReadingError as error:
        _refuse(files[error.source], error, texts[error.source])
    if units.run and not measured.runs:  # where there are several, their reader refuses it itself
        try:
            run_place(units.run, ["1"])
        except ReadingError as error:
            _refuse(files[0], error)
    return measured


def _refuse(name: str, error: ReadingError, text: str = "") -> NoReturn:
    for fault in error.faults:
        hint = f"\n  hint: {fault.hint}" if fault.hint else ""
        click.echo(
            f"{name}:{fault.line}:{fault.column(text)}: error: {fault.reason}{hint}", err=True
        )
    sys.exit(1)


def cut(measured: Measured, begin: float | None, end: float | None) -> Measured:
    """Only the readings between two times, in s."""
    if begin is None and end is None:
        return measured
    try:
        return between(measured, begin, end)
    except ReadingError as error:
        _refuse("--from/--until", error)
