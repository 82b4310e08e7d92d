"""Inelastic collapse of dead bumpers that have stayed pressed in.

A bumper with e = 0 that has not cleared is rigid where it is pressed again: at its remembered
overlap d the force jumps from nought to k d, which ends an approach w after m w/(k d), at once as
far as a clock can tell. Three bodies (a wall is one) with two such gaps between them hit each other
in turn for ever, and each round leaves a fixed part of the speeds, as in `collapse`; so do two of
which one gap is hit without a duration, even where that gives all back. Once an
approach is `AT_REST` of the fastest one so far, all that were hit at that instant and move alike
go on with the velocity of their centre of mass.
"""

from __future__ import annotations

from sim.dynamics.loop.collapse import one_velocity
from sim.dynamics.loop.impacts import AT_REST
from sim.dynamics.loop.rooms import resting
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.state.body import Gap
from sim.dynamics.state.chain import Chain, place, velocity
from sim.dynamics.state.clock import Time, elapsed
from sim.dynamics.state.flips import UNDECIDED


def run_of(chain: Chain, gap: Gap, now: Time, instant: float, fastest: float) -> list[Gap]:
    """The gaps of all bodies that go on together instead of this touch; often none.

    `instant` [s]: what is closer together happens at one instant; `fastest` [m/s]: the greatest
    approach so far. From left to right.
    """
    often = gap.flips >= UNDECIDED and elapsed(gap.changed, now) <= instant
    slowest = AT_REST * fastest
    if not often or -gap.rate > slowest or not _is_rigid(gap):
        return []
    run = [gap]
    while (before := chain.neighbours(run[0])[0]) and _belongs(before, now, instant, slowest):
        run.insert(0, before)
    while (after := chain.neighbours(run[-1])[1]) and _belongs(after, now, instant, slowest):
        run.append(after)
    return run


def together(run: list[Gap], now: Time, ledger: Ledger) -> None:
    """All bodies of these gaps, which fly freely, get one velocity; no overlap changes."""
    bodies = [run[0].left, *(member.right for member in run)]
    for body in bodies:
        place(body, now)
    one_velocity(bodies, ledger)
    for member in run:
        member.room, member.rate, member.time = -resting(member), 0.0, now


def _is_rigid(gap: Gap) -> bool:
    """Is it a dead bumper that is where it would be pressed again?"""
    return gap.law is not None and gap.law.linear and gap.law.e == 0.0 and resting(gap) > 0.0


def _belongs(gap: Gap, now: Time, instant: float, slowest: float) -> bool:
    """Was this gap hit at the same instant, and do its bodies move alike by now?"""
    rigid = _is_rigid(gap) or (gap.law is None and not gap.contact.joins)
    free = gap.left.motion is None and gap.right.motion is None
    if not free or gap.joined or not rigid:
        return False
    alike = abs(velocity(gap.right, now) - velocity(gap.left, now)) <= slowest
    return alike and elapsed(gap.changed, now) <= instant
