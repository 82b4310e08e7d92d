"""What can end the motion of a row: functions that are positive until they do."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from sim.certify.bodies import Body, Gap
from sim.certify.instants import Instant
from sim.certify.numbers.arithmetic import arb
from sim.certify.numbers.balls import ZERO, Ball, NotProvableError, is_zero
from sim.certify.numbers.roots import first_root
from sim.certify.phases import ContactPhase
from sim.certify.series import Piece
from sim.certify.signals import Signal, total
from sim.scene.said import said


@dataclass(frozen=True, slots=True)
class Watch:
    """A function that is positive until it ends the motion."""

    signal: Callable[[Piece], Signal]
    cause: str
    doubt: str
    gap: Gap | None = None
    body: Body | None = None


def signal(
    k: int, factors: tuple[Ball, Ball, Ball], *, nought: bool = False
) -> Callable[[Piece], Signal]:
    """a o + b o′ + c of gap k; `nought`: exactly 0 where the first piece begins."""

    def within(piece: Piece) -> Signal:
        found = piece.overlap(k, factors)
        if not (nought and piece.first):
            return found
        return Signal((ZERO, *found.terms[1:]), found.tails)

    return within


def open_gap(gap: Gap, k: int) -> list[Watch]:
    """What happens first in a gap with a spring whose bodies do not touch."""
    if gap.left.still and gap.right.still:
        return []
    one, none = arb(1), ZERO
    doubt = said("whether {pair} meet", pair=gap.shown)
    lingers = True
    if gap.tail is not None:
        stiff, damper = gap.tail
        room = signal(k, (-stiff, -damper, none), nought=gap.spent)
    elif not is_zero(gap.memory):
        room = signal(k, (-one, none, gap.rest()), nought=gap.spent)
    else:
        lingers, room = False, signal(k, (-one, none, none), nought=is_zero(gap.room))
    found = [Watch(room, "touch", doubt, gap)]
    if lingers:
        found.append(Watch(signal(k, (one, none, none)), "clear", doubt, gap))
    doubt = said("when the spring between {pair} has its full length", pair=gap.shown)
    for spring in gap.loose:
        found.append(Watch(signal(k, (one, none, -spring.rest)), "fall", doubt, gap))
    return found


def swing_ends(phase: ContactPhase, horizon: Ball) -> Iterator[tuple[Ball, str]]:
    """When two between whom springs alone act meet, or a spring that was let go is at its end."""
    gap, swing = phase.gap, phase.swing
    doubt = said("when the spring between {pair} has its full length", pair=gap.shown)
    rests = [(one.rest, 1, "fall", doubt) for one in gap.loose]  # no swing goes on after it
    rests.append((ZERO, -1, "touch", said("whether {pair} meet", pair=gap.shown)))
    for rest, sign, cause, doubt in rests:

        def above(tau: Ball, rest: Ball = rest, sign: int = sign) -> Ball:
            return sign * (swing.at(tau)[0] - rest)

        def rate(tau: Ball, sign: int = sign) -> Ball:
            return sign * swing.at(tau)[1]

        def curve(tau: Ball, sign: int = sign) -> Ball:
            return sign * swing.all(tau)[2]

        begins = None
        if cause == "touch" and is_zero(gap.room):  # they part, or nothing is known
            if not gap.rate > 0 and not (is_zero(gap.rate) and curve(ZERO) > 0):
                raise NotProvableError(doubt)
            begins = curve if is_zero(gap.rate) else None
        tau = first_root(above, rate, horizon, doubt, curve=begins)
        if tau is not None:
            horizon = min(horizon, tau.upper().mid())
            yield tau, cause


def grips(row: list[Body], gaps: list[Gap], now: Instant, silent: set[Body]) -> Iterator[Watch]:
    """Where a sliding body stops, or a held one is pushed away; not of those that a wall turns."""
    for j, body in enumerate(row):
        if body.mass is None:
            continue
        if body.held:
            doubt = said(
                "whether friction holds a cart in the contact of {pair}", pair=_near(gaps, j)
            )
            load = body.force(now)
            for direction in (1, -1):
                yield Watch(_room(len(gaps), body, j, load, direction), "slip", doubt, body=body)
        elif body.sliding and body not in silent:
            doubt = said("whether a cart stops in the contact of {pair}", pair=_near(gaps, j))

            def speed(piece: Piece, j: int = j, direction: int = body.sliding) -> Signal:
                return total([(direction, piece.speed(j))], ZERO)

            yield Watch(speed, "halt", doubt, body=body)


def _room(gaps: int, body: Body, j: int, load: Ball, direction: int) -> Callable[[Piece], Signal]:
    """What friction can still hold against a push to the right (direction 1) or the left, N."""

    def room(piece: Piece) -> Signal:
        pushes = [(-direction, piece.force(j - 1))] if j else []
        if j < gaps:
            pushes.append((direction, piece.force(j)))
        return total(pushes, body.static - direction * load)

    return room


def _near(gaps: list[Gap], j: int) -> str:
    return gaps[max(j - 1, 0)].shown if gaps else ""
