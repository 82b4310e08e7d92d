"""The curves of each graph. Its twin is `sim/web/src/series.js`.

A force graph has two curves for each contact: on the left body by the right one and the other way
round; sizes by default, with a sign (+ to the right) when asked for.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sim.pages.language import tr
from sim.pages.widget.effects_forces import outside
from sim.pages.widget.run import Run
from sim.pages.widget.words import brief


@dataclass(frozen=True, slots=True)
class Series:
    """One curve. `style` b0…b7 is the body's colour, `wall` or `total`; `over`: drawn dashed."""

    label: str
    style: str
    over: bool
    values: Sequence[float]
    slopes: Sequence[float] | None


def series_of(
    quantity: str,
    header: Mapping[str, Any],
    run: Run,
    camera: float,
    *,
    signed: bool = False,
    per: float = 1.0,
) -> list[Series]:
    """The curves of `quantity` (x, v, a, F, p, energy), as a camera at `camera` m/s sees them.

    `per`: m/s in the unit of the velocity graph.
    """
    if quantity == "F":
        return _forces(header, run, signed)
    curves = []
    for i, body in enumerate(header["bodies"]):
        name, mass = body["name"], body["mass"]
        x, v, a = run.x[name], run.v[name], run.a[name]
        seen = [speed - camera for speed in v]
        values: Sequence[float]
        slopes: Sequence[float] | None
        if quantity == "x":
            values = [place - camera * t for place, t in zip(x, run.t, strict=True)]
            slopes = seen
        elif quantity == "v":
            values, slopes = [s / per for s in seen], [rate / per for rate in a]
        elif quantity == "a":
            values, slopes = a, None
        elif quantity == "p":
            values, slopes = [mass * s for s in seen], [mass * s for s in a]
        else:
            values, slopes = [mass * s * s / 2 for s in seen], None
        curves.append(Series(name, f"b{i % 8}", False, values, slopes))
    if quantity == "p" and outside(header):
        curves.append(_partner(curves, outside(header)))
    if quantity in ("p", "energy") and len(curves) > 1:
        curves.append(_total(curves))
    return curves


def _partner(curves: Sequence[Series], label: str) -> Series:
    """What the carts have given away: to the wall, and the wall to the Earth."""
    whole = _total(curves)
    given = [whole.values[0] - value for value in whole.values]
    slopes = None if whole.slopes is None else [-slope for slope in whole.slopes]
    return Series(label, "wall", False, given, slopes)


def _total(curves: Sequence[Series]) -> Series:
    values = [sum(row) for row in zip(*(c.values for c in curves), strict=True)]
    slopes = None
    if all(c.slopes is not None for c in curves):
        slopes = [sum(row) for row in zip(*(c.slopes or () for c in curves), strict=True)]
    label = tr("all carts")
    if any(c.style == "wall" for c in curves):
        label = tr("all together")
    return Series(label, "total", False, values, slopes)


def _forces(header: Mapping[str, Any], run: Run, signed: bool) -> list[Series]:
    styles = {body["name"]: f"b{i % 8}" for i, body in enumerate(header["bodies"])}
    sign = -1.0 if signed else 1.0
    curves = []
    for contact in header["contacts"]:
        force, slope = run.F.get(contact["pair"]), run.rate.get(contact["pair"])
        if force is None or slope is None or not any(force):
            continue
        if not signed:  # sizes: a spring pulls with less than 0
            slope = [-s if f < 0 else s for f, s in zip(force, slope, strict=True)]
            force = [abs(f) for f in force]
        left, right = contact["bodies"]
        curves.append(
            Series(
                tr("on {on} by {by}", on=brief(left), by=brief(right)),
                styles.get(left, "wall"),
                False,
                [sign * f for f in force],
                [sign * s for s in slope],
            )
        )
        label = tr("on {on} by {by}", on=brief(right), by=brief(left))
        curves.append(Series(label, styles.get(right, "wall"), True, force, slope))
    return curves
