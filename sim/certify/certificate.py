"""A certificate, as `carts run --certify` prints it.

Bounds are decimal strings of doubles, the nearest ones outside of the ball. More bits are taken
until the ends are as narrow as the inputs allow: with tolerances they are as wide as those say.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from sim.certify.band import Seen, Spans, pieces, united, united_seen
from sim.certify.inputs import inputs
from sim.certify.instants import Instant
from sim.certify.numbers.arithmetic import ctx
from sim.certify.numbers.balls import (
    UNIT,
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
from sim.certify.order import at_once, called
from sim.certify.row import Told
from sim.certify.run import BallRun, Limit
from sim.scene.model import Scene, Track
from sim.scene.said import reason_of, said
from sim.scene.track import body_name

BITS = (160, 320, 1280, 2560, 5120)
"""Precision of the balls, one after the other. A pair is done with the first; a thousand contacts
that multiply every error by ten each take the last."""

NARROW = 2.0**-50
"""Of the greatest place or speed of the scene. A ball so small is wide by its inputs alone."""

INPUTS = 2.0**-40
"""The same where an input is a double wide itself (a gap in both readings): 160 bits would be known
to 2⁻¹⁴⁰ and more, so all of such a width is what the inputs make of themselves."""

SPARE = 2.0**-100
"""Of the largest number of its kind. Bounds leave so much more room (nothing, beside a double), so
that an independent run with thirty digits or more finds its own rounded answer inside."""

ORDER = ("contact", "release", "peak", "separate", "stick", "stop", "start", "end")
"""Events of one instant are listed in this order of kinds, as in a run."""

WITHIN = Limit()


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
    seen: Seen = field(default_factory=dict)
    wide: bool = False  # is an input known to a double only?


def certify(scene: Scene, *, limit: Limit = WITHIN, instants: Sequence[float] = ()) -> Certificate:
    """Run a scene in balls, within a limit, and look at it at `instants` [s], in order.

    Never raises for what cannot be proved: the certificate says it.
    """
    before = ctx.prec
    try:
        if scene.tolerances:  # more bits than the first would not help: the inputs are wide
            ctx.prec = BITS[0]
            return _whole([_best(scene, p, limit, instants) for p in pieces(scene.tolerances)])
        best: Certificate | None = None
        for bits in BITS:
            ctx.prec = bits
            found = _best(scene, {}, limit, instants)
            enough = _enough(found, best) or (best is not None and _stuck(found, best))
            if best is None or found.x or not best.x:
                best = found
            if enough:
                break
        assert best is not None
        return best
    finally:
        ctx.prec = before


def _whole(parts: list[Certificate]) -> Certificate:
    """What holds for all of them: the same events in the same order, wherever the truth lies."""
    first = parts[0]
    happens = [(one.kind, one.bodies) for one in first.events]
    for one in parts:
        if not one.x:
            return one
    if any([(event.kind, event.bodies) for event in one.events] != happens for one in parts):
        reason = said("what happens, and in which order, depends on the tolerances")
        return Certificate({}, {}, (), False, reason, first.bits, True)
    x, v = (
        {name: united([getattr(one, key)[name] for one in parts]) for name in first.x}
        for key in ("x", "v")
    )
    rows = zip(*(one.events for one in parts), strict=True)
    events = tuple(
        Told(Instant(united([one.when.ball for one in row])), row[0].kind, row[0].bodies)
        for row in rows
    )
    doubt = next((one.reason for one in parts if not one.proved), "")
    seen = united_seen([one.seen for one in parts])
    return Certificate(x, v, events, not doubt, doubt, first.bits, seen=seen)


def _enough(found: Certificate, last: Certificate | None) -> bool:
    """Would more bits not help?"""
    if not found.x:
        return found.hopeless
    if last is not None and last.x and _width(found) > 0.5 * _width(last):
        return True
    return _width(found) <= (INPUTS if found.wide else NARROW)


def _stuck(found: Certificate, last: Certificate) -> bool:
    """Has it ended where fewer bits did? What touches exactly, or comes at once, stays so."""
    happened = len(found.events) == len(last.events)
    return not found.x and not last.x and happened and found.reason == last.reason


def _width(found: Certificate) -> float:
    """The greatest radius as a part of the greatest number of its kind."""
    widest = 0.0
    for balls in (found.x.values(), found.v.values()):
        largest = max(float(abs(ball).upper()) for ball in balls)
        radius = max(float(ball.rad()) for ball in balls)
        widest = max(widest, radius / largest if largest else radius)
    return widest


def _best(scene: Scene, spans: Spans, limit: Limit, instants: Sequence[float]) -> Certificate:
    """With both readings of a gap if that can be proved, else with the scene's own."""
    wide = _run(scene, spans, limit, instants, wide=True)
    if wide.proved or wide.hopeless:
        return wide
    narrow = _run(scene, spans, limit, instants, wide=False)
    return narrow if narrow.proved or len(narrow.x) >= len(wide.x) else wide


def _run(
    scene: Scene, spans: Spans, limit: Limit, instants: Sequence[float], *, wide: bool
) -> Certificate:
    names = [cart.name for cart in scene.carts]
    run: BallRun | None = None
    try:
        given = inputs(scene, spans, wide=wide)
        run = BallRun(given)
        run.go(limit, instants)
        x = {n: p + m for n, p, m in zip(names, given.places, run.moved, strict=True)}
        v = {n: body.v for n, body in zip(names, run.bodies, strict=True)}
        for ball in (*x.values(), *v.values()):
            bounds(ball)
    except NotProvableError as error:
        told = () if run is None else _sorted(run, names)
        hopeless = isinstance(error, NoBoundError)
        return Certificate({}, {}, told, False, reason_of(error), ctx.prec, hopeless)
    events = _sorted(run, names)
    doubt = run.doubt or _unordered(events, run.scene.track)
    seen = {
        t: ([p + m for p, m in zip(given.places, moved, strict=True)], speeds)
        for t, (moved, speeds) in run.seen.items()
    }
    inexact = any(gap.rad() > 0 for gap in given.gaps)
    return Certificate(x, v, events, not doubt, doubt, ctx.prec, seen=seen, wide=inexact)


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


def _unordered(events: tuple[Told, ...], track: Track) -> str:
    """Two that follow each other in the list, though that is not proved; or ""."""
    for one, other in itertools.pairwise(events):
        if one.when is not other.when and not lower(other.when.ball) >= upper(one.when.ball):
            names = [[body_name(name, track) for name in e.bodies] for e in (one, other)]
            return at_once(called(one.kind, names[0]), called(other.kind, names[1]))
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
    wide = ball if is_zero(ball) else ball + UNIT * largest * SPARE
    low, high = bounds(wide)
    return [repr(low + 0.0), repr(high + 0.0)]
