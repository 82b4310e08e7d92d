"""A certificate held against the oracle: which of its claims miss what forty digits say."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from mpmath import mpf

from sim.certify.certificate import ORDER
from sim.scene import Scene
from tests.reference.digit_pairs import UnsupportedError
from tests.reference.digit_row import NOTHING
from tests.reference.many_digits import Digits, integrate

LEFT_OUT = ("peak", "end")
"""Kinds of events that the oracle does not look for."""


NO_BOUND = {
    *("drag-quadratic", "magnets-collision", "magnets-repel", "hertz-cradle", "hertz-pair"),
    *("push-a-train", "triple-hit"),
}
"""Scenes of the registry without a certificate: other effects, Hertz, a pair that stays pressed
together, two ends at one instant."""


HARD_WITHOUT_BOUND = {
    *("collapse-below", "zeno-on-a-slope"),
    *("triple-hit-paper", "triple-hit-bumper", "hertz-cradle-3", "hertz-cradle-4"),
    *("hertz-cradle-5", "quadratic-drag", "falling-in-air", "magnets-turning-point"),
    "magnets-at-any-time",
}
"""Hard cases without one: bounces without a last time, two ends at one instant, and as above."""


def exactly(number: mpf) -> Fraction:
    """Every digit of it."""
    sign, mantissa, exponent, _ = number._mpf_  # mpf(number) would round it
    return Fraction((-1) ** sign * int(mantissa)) * Fraction(2) ** int(exponent)


def widths(certificate: dict[str, Any]) -> list[float]:
    """Of places and velocities at the end, in units of the last place of a double."""
    found = []
    for ends in certificate["final"].values():
        for low, high in (map(float, bounds) for bounds in ends.values()):
            found.append((high - low) / (max(abs(low), abs(high)) * 2.0**-52 or 1.0))
    return found


def misses(scene: Scene, certificate: dict[str, Any]) -> list[str]:
    """What of a certificate is not so; empty: all holds. Raises where the oracle cannot tell."""
    if any(float(e["t"][1]) >= scene.until for e in certificate["events"] if e["kind"] != "end"):
        raise UnsupportedError("an event comes as the run ends: the oracle ends before it")
    oracle = integrate(scene)
    return [*_ends(scene, certificate, oracle), *_events(certificate, oracle)]


def _ends(scene: Scene, certificate: dict[str, Any], oracle: Digits) -> list[str]:
    found = []
    for k, cart in enumerate(scene.carts):
        group = oracle.group(k)
        assert group is not None
        truth = {
            "x": Fraction(cart.position) + exactly(oracle.moved[k]),
            "v": exactly(group.v),
        }
        for kind, value in truth.items():
            low, high = certificate["final"][kind][cart.name]
            if low == high == "0.0" and abs(value) <= exactly(NOTHING):
                continue  # the oracle's rounding of what is nought
            if not Fraction(float(low)) <= value <= Fraction(float(high)):
                found.append(f"{kind}.{cart.name} = {float(value)!r} not in [{low}, {high}]")
    return found


def _listed(event: tuple[mpf, str, tuple[str, ...]], oracle: Digits) -> tuple[int, int, int]:
    """Those of one instant stand in a list by kind, then from left to right, as in a run."""
    t, kind, bodies = event
    row = ["left", *(cart.name for cart in oracle.scene.carts), "right"]
    return int(exactly(t) * 10**30), ORDER.index(kind), row.index(bodies[0])


def _events(certificate: dict[str, Any], oracle: Digits) -> list[str]:
    mine = [event for event in certificate["events"] if event["kind"] not in LEFT_OUT]
    theirs = sorted(oracle.events, key=lambda e: _listed(e, oracle))
    if certificate["order"] != "proved":  # those of one instant may come in either order
        mine = sorted(mine, key=lambda e: (e["bodies"], float(e["t"][0]), ORDER.index(e["kind"])))
        theirs = sorted(theirs, key=lambda e: (list(e[2]), e[0]))
    names = [(event["kind"], tuple(event["bodies"])) for event in mine]
    if names != [(kind, bodies) for _, kind, bodies in theirs]:
        return [f"events {names} are {[(kind, bodies) for _, kind, bodies in theirs]}"]
    found = []
    for event, (t, kind, bodies) in zip(mine, theirs, strict=True):
        low, high = event["t"]
        if not Fraction(float(low)) <= exactly(t) <= Fraction(float(high)):
            found.append(f"{kind} of {bodies} at {float(t)!r} not in [{low}, {high}]")
    return found
