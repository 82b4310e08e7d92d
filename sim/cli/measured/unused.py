"""Options of `carts fit` that these readings have no use for: none is passed over in silence."""

from __future__ import annotations

import click

from sim.cli.typed_options import typed
from sim.measured.track import Content
from sim.measured.tracks import HELD, Measured

OF_POSITIONS = {
    "law": "--law", "friction": "--friction", "tilt": "--tilt", "contact": "--contact",
    "spans": "--segment", "flips": "--flip", "zeros": "--zero", "masses": "--mass",
    "touch": "--touch",
}  # fmt: skip
OF_UNITS = ("time", "length", "force")
OF_MODEL = ("law", "friction", "tilt")


def only_of_positions(ctx: click.Context, kind: Content) -> None:
    """Refuses what only the motion of carts has, where forces or accelerations were read."""
    wrong = typed(ctx, OF_POSITIONS)
    if wrong and kind != "length":
        options = ", ".join(OF_POSITIONS[name] for name in wrong)
        raise click.UsageError(f"{options}: for positions only; these files hold {HELD[kind]}.")


def warn_of_units(ctx: click.Context, measured: Measured) -> None:
    """One line for each unit that was given and that no column needed."""
    for name in typed(ctx, OF_UNITS):
        if name in measured.assumed:
            continue
        absent = name not in ("time", measured.kind)
        why = f"the files hold {HELD[measured.kind]}" if absent else "the files name their own unit"
        _warn(f"--{name} {ctx.params[name]}", why)


def warn_of_model(ctx: click.Context) -> None:
    """One line for what only the model of a bounce takes, where no such model was fitted."""
    for name in typed(ctx, OF_MODEL):
        _warn(OF_POSITIONS[name], "it belongs to the model of a bounce, and none was fitted")


def _warn(option: str, why: str) -> None:
    click.echo(f"warning: {option} changes nothing: {why}", err=True)
