"""Options that name a cart or hold a quantity: read into SI, or told how they should look."""

from __future__ import annotations

import click

from sim.measured.cart_names import cart_of
from sim.measured.events.by_hand import Given
from sim.measured.events.stretch import KINDS
from sim.scene.quantity import MASS, TIME, Dimension, QuantityError, read_quantity


def quantity(option: str, text: str | None, dimension: Dimension) -> float | None:
    """The quantity in SI; raises click's usage error."""
    if text is None:
        return None
    try:
        return float(read_quantity(text, dimension))
    except QuantityError as error:
        raise click.UsageError(f"{option} {text}: {error.message}; {error.hint}.") from None


def named(option: str, given: tuple[str, ...], names: tuple[str, str]) -> tuple[str, ...]:
    """The names given, all of them carts."""
    return tuple(_cart(option, name, name, names) for name in given)


def _cart(option: str, text: str, name: str, names: tuple[str, str]) -> str:
    """The cart of that name, also as Tracker calls it; raises click's usage error."""
    for one in (name, cart_of(name)):
        if one in names:
            return one
    known = " and ".join(names)
    raise click.UsageError(f"{option} {text}: there is no cart “{name}”; there are {known}.")


def values_by_cart(
    option: str, texts: tuple[str, ...], names: tuple[str, str], dimension: Dimension, sample: str
) -> dict[str, float]:
    """NAME=VALUE, read into SI."""
    found: dict[str, float] = {}
    for text in texts:
        name, equals, value = text.partition("=")
        number = quantity(option, value, dimension) if equals else None
        if number is None:
            what = "MASS" if dimension is MASS else "LENGTH"
            raise click.UsageError(f"{option} {text}: write NAME={what}, for example {sample}.")
        cart = _cart(option, text, name.strip(), names)
        if cart in found:
            raise click.UsageError(f"{option} {text}: {cart} has one already.")
        found[cart] = number
    return found


def segments(option: str, texts: tuple[str, ...], names: tuple[str, str]) -> tuple[Given, ...]:
    """KIND=FROM..UNTIL of both carts, or NAME:KIND=FROM..UNTIL of one."""
    found = []
    for text in texts:
        what, _, span = text.partition("=")
        name, colon, kind = what.rpartition(":")
        first, dots, last = span.partition("..")
        begin = quantity(option, first.strip(), TIME) if dots else None
        end = quantity(option, last.strip(), TIME) if dots else None
        if begin is None or end is None or not begin < end:
            sample = "contact=1.20..1.34 or A:hand=0..0.6"
            raise click.UsageError(
                f"{option} {text}: write KIND=FROM..UNTIL in s, for example {sample}."
            )
        known = [one for one in KINDS if one == kind.strip()]
        if not known:
            raise click.UsageError(f"{option} {text}: KIND is one of {', '.join(KINDS)}.")
        if colon and known[0] == "contact":
            raise click.UsageError(f"{option} {text}: a contact is of both carts: without a name.")
        cart = names.index(_cart(option, text, name.strip(), names)) if colon else None
        found.append(Given(known[0], begin, end, cart))
    return tuple(found)


def weighed(texts: tuple[str, ...], names: tuple[str, str]) -> dict[str, float]:
    """Masses by name, in kg."""
    found = values_by_cart("--mass", texts, names, MASS, "A=0.5kg")
    for name, mass in found.items():
        if mass <= 0.0:
            raise click.UsageError(f"--mass {name}={mass:g} kg: a mass is more than 0.")
    return found
