"""What a world breaks, told: sentences and amounts as a reader of a lesson knows them."""

from __future__ import annotations

from decimal import Decimal
from typing import Literal

from sim.scene.notation import SUPERSCRIPT
from sim.scene.said import said

Way = Literal["gone", "came", "both"]
"""What no body gave went against all momentum that was there, along with it, or first one and then
the other."""

PLAIN = (1e-3, 1e6)
"""N s, J. What is smaller or larger than these is told with a power of ten, as on the page."""


def momentum_said(value: float, way: Way) -> str:
    """Of N s from nowhere."""
    size = amount(abs(value), "N s")
    if way == "gone":
        return said("{amount} of momentum are gone, and nobody has them.", amount=size)
    if way == "came":
        return said("{amount} of momentum came from nowhere.", amount=size)
    if value > 0.0:
        return said("{amount} of momentum to the right came from no body.", amount=size)
    return said("{amount} of momentum to the left came from no body.", amount=size)


def most_said(value: float) -> str:
    """Of N s that were there for a time."""
    size = amount(abs(value), "N s")
    return said("For a while {amount} of momentum were there that no body gave.", amount=size)


def energy_said(value: float) -> str:
    """Of J from nowhere."""
    size = amount(abs(value), "J")
    if value > 0.0:
        return said("{amount} of energy came from nowhere.", amount=size)
    return said("{amount} of energy are gone, and nothing has become warm.", amount=size)


def observers_said(cart: str, ground: float, train: float) -> str:
    """Of m/s of one cart at the end, both as the ground sees it: from a train every velocity is
    another, and that alone would be no disagreement."""
    return said(
        "Two observers disagree. Computed from the ground, {cart} ends with {ground}. "
        "Computed from a moving train, with the train's velocity added back at the end, {cart} "
        "ends with {train}. In our world both agree.",
        cart=cart,
        ground=speed(ground),
        train=speed(train),
    )


def amount(value: float, unit: str) -> str:
    """Two digits that count, written out: nobody in a lesson reads 1.9e+04."""
    text = f"{value:.1e}"
    if PLAIN[0] <= float(text) < PLAIN[1]:
        plain = format(Decimal(text), "f")
        return f"{plain.rstrip('0').rstrip('.') if '.' in plain else plain} {unit}"
    digits, power = text.split("e")
    return f"{digits} × 10{str(int(power)).translate(SUPERSCRIPT)} {unit}"


def speed(v: float) -> str:
    """Of m/s, as a reader compares two of them."""
    text = f"{v:.2f}".replace("-0.00", "0.00")
    return f"{text} m/s".replace("-", "\N{MINUS SIGN}")
