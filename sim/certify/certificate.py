"""A certificate, as `carts run --certify` prints it.

Bounds are decimal strings of doubles, the nearest ones outside of the ball. More bits are taken
until the ends are as narrow as the inputs allow: with tolerances they are as wide as those say.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import Any

from flint import arb, ctx

from sim.certify.balls import (
    ZERO,
    Ball,
    NoBoundError,
    NotProvableError,
    bounds,
    exact,
    is_zero,
    lower,
    upper,
)
from sim.certify.inputs import inputs
from sim.certify.row import Told
from sim.certify.run import BallRun
from sim.scene.model import Scene

BITS = (160, 320, 1280, 5120)
"""Precision of the balls, one after the other. A pair is done with the first; a thousand contacts
that multiply every error by ten each take the last."""

NARROW = 2.0**-50
"""Of the greatest place or speed of the scene. A ball so small is wide by its inputs alone."""

SPARE = 2.0**-100
"""Of the largest number of its kind. Bounds leave so much more room (nothing, beside a double), so
that an independent run with thirty digits or more finds its own rounded answer inside."""

ORDER = ("contact", "release", "peak", "separate", "stick", "stop", "start", "end")
"""Events of one instant are listed in this order of kinds, as in a run."""


@dataclass(frozen=True, slots=True)
class Certificate:
    """Balls of the end, and the events in order; `reason` says what is not proved."""

    x: dict[str, Ball]
    v: dict[str, Ball]
    events: tuple[Told, ...]
    proved: bool
    reason: str
    bits: int
    hopeless: bool = False  # for more digits


def certify(scene: Scene) -> Certificate:
    """Run a scene in balls. Never raises for what cannot be proved: the certificate says it."""
    before = ctx.prec
    try:
        best: Certificate | None = None
        for bits in BITS:
            ctx.prec = bits
            found = _best(scene)
            enough = _enough(found, best, scene)
            if best is None or found.x or not best.x:
                best = found
            if enough:
                break
        assert best is not None
        return best
    finally:
        ctx.prec = before


def _enough(found: Certificate, last: Certificate | None, scene: Scene) -> bool:
    """Would more bits not help?"""
    if scene.tolerances:
        return True
    if not found.x:
        return found.hopeless
    if last is not None and last.x and _width(found) > 0.5 * _width(last):
        return True
    return _width(found) <= NARROW


def _width(found: Certificate) -> float:
    """The greatest radius as a part of the greatest number of its kind."""
    widest = 0.0
    for balls in (found.x.values(), found.v.values()):
        largest = max(float(abs(ball).upper()) for ball in balls)
        radius = max(float(ball.rad()) for ball in balls)
        widest = max(widest, radius / largest if largest else radius)
    return widest


def _best(scene: Scene) -> Certificate:
    """With both readings of a gap if that can be proved, else with the scene's own."""
    wide = _run(scene, wide=True)
    if wide.proved or wide.hopeless:
        return wide
    narrow = _run(scene, wide=False)
    return narrow if narrow.proved or len(narrow.x) >= len(wide.x) else wide


def _run(scene: Scene, *, wide: bool) -> Certificate:
    names = [cart.name for cart in scene.carts]
    run: BallRun | None = None
    try:
        given = inputs(scene, wide=wide)
        run = BallRun(given)
        run.go()
        x = {n: p + m for n, p, m in zip(names, given.places, run.moved, strict=True)}
        v = {n: body.v for n, body in zip(names, run.bodies, strict=True)}
        for ball in (*x.values(), *v.values()):
            bounds(ball)
    except NotProvableError as error:
        told = () if run is None else _sorted(run, names)
        hopeless = isinstance(error, NoBoundError)
        return Certificate({}, {}, told, False, str(error), ctx.prec, hopeless)
    events = _sorted(run, names)
    doubt = run.doubt or _unordered(events)
    return Certificate(x, v, events, not doubt, doubt, ctx.prec)


def _sorted(run: BallRun, names: list[str]) -> tuple[Told, ...]:
    place = {name: k for k, name in enumerate(["left", *names, "right"])}
    rows = [
        (exact_middle(one.when.ball), ORDER.index(one.kind), place[one.bodies[0]])
        for one in run.told
    ]
    order = sorted(range(len(rows)), key=rows.__getitem__)
    return tuple(run.told[k] for k in order)


def exact_middle(ball: Ball) -> Any:
    """The middle of a ball, to sort by."""
    return (lower(ball) + upper(ball)) / 2


def _unordered(events: tuple[Told, ...]) -> str:
    """Two that follow each other in the list, though that is not proved; or ""."""
    for one, other in itertools.pairwise(events):
        if one.when is not other.when and not lower(other.when.ball) >= upper(one.when.ball):
            pairs = [f"{e.kind} of {' and '.join(e.bodies)}" for e in (one, other)]
            return f"{pairs[0]} and {pairs[1]} come at one instant, as far as can be told"
    return ""


def document(found: Certificate) -> dict[str, Any]:
    """The JSON object of the interface."""
    longest = found.events[-1].when.ball if found.events else exact(1.0)
    x, v = (_largest(balls) for balls in (found.x, found.v))
    return {
        "final": {"x": _named(found.x, x), "v": _named(found.v, v + x / longest)},
        "events": [
            {
                "t": _text(one.when.ball, ZERO if one.kind == "end" else longest),
                "kind": one.kind,
                "bodies": list(one.bodies),
            }
            for one in found.events
        ],
        "order": "proved" if found.proved else "not-provable",
        "reason": found.reason,
        "bits": found.bits,
    }


def _largest(balls: dict[str, Ball]) -> Ball:
    return max((abs(ball).upper() for ball in balls.values()), default=ZERO)


def _named(balls: dict[str, Ball], largest: Ball) -> dict[str, list[str]]:
    return {name: _text(ball, largest) for name, ball in balls.items()}


def _text(ball: Ball, largest: Ball) -> list[str]:
    """Bounds; what is nought and nothing else stays so."""
    wide = ball if is_zero(ball) else ball + arb(0, 1) * largest * SPARE
    low, high = bounds(wide)
    return [repr(low + 0.0), repr(high + 0.0)]
