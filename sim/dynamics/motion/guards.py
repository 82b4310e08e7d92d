"""What ends a step of coupled bodies: quantities that are positive until something happens."""

from __future__ import annotations

import math

from sim.dynamics.motion.power_series.polynomial import Poly, slope
from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.clock import Time
from sim.dynamics.state.loads import Load
from sim.laws.branch import APART, LOCKED, Branch, Guard
from sim.scene.said import said

PUSH_ROUNDING = 1e-12
"""Of k d. Spring and damper cancel at separation; what rounding leaves of them is no push."""


def force_now(gap: Gap, branch: Branch) -> float:
    """N. The contact's force just now; 0 for a locked one."""
    if gap.law is not None and not gap.law.linear and gap.touching is not None:
        return gap.law.force(gap.mu, -gap.room, -gap.rate)
    return branch.force(-gap.room, -gap.rate)


def push_now(gap: Gap, branch: Branch) -> float:
    """N. All that pushes the two apart just now: the contact, springs and magnets."""
    linked = sum(link.force(gap.room, gap.rate) for link in gap.links)
    return force_now(gap, branch) + linked


def branch_of(gap: Gap) -> Branch:
    """The linear branch of its law that holds in a gap just after now."""
    if gap.touching is None:
        return APART
    if gap.law is None:  # an instant contact at rest
        return LOCKED
    pressing = gap.touching.pressing
    return gap.law.branch(gap.mu, -gap.room, -gap.rate, gap.memory, pressing=pressing)


def guards_of(gap: Gap, branch: Branch) -> tuple[Guard, ...]:
    """What ends the present branch of a gap.

    Where the pair touches its law says. Where it is linked only it is the touch: a bumper that has
    not cleared touches at its resting overlap, a pair that may push again when its force turns
    positive, unless it clears first, and one that a release parted when it is pressed again.
    """
    own = _guards(gap, branch)
    if gap.loose:
        own = (*own, *offs_of(gap))
    return (*own, NEAREST) if gap.rate < 0.0 and _comes_near(gap) else own


NEAREST = Guard("nearest", "rate")

STILL = 1e-9
"""Of the speed that force and room between a pair can give. What is slower does not come nearer."""


def _comes_near(gap: Gap) -> bool:
    """Does a pair close whose force has no limit, so that it never touches?"""
    if not any(link.nearest for link in gap.links):
        return False
    force = abs(math.fsum(link.force(gap.room, 0.0) for link in gap.links))
    return -gap.rate > STILL * math.sqrt(force * gap.room / gap.mu)


GRAZES = 2e-15
"""Of a bumper's greatest overlap. A cart that hops or shakes on its steep line comes just as deep
every time: what rounding adds to that is no pressing further, which would take two phases more.
One that is laid on it swings back to no force, and what rounding takes from that is no parting."""


def passed(guard: Guard) -> float:
    """The level at which what a guard watches does not graze its level any more, but passes it."""
    deeper = guard.cause == "climb" and guard.of == "overlap"
    return guard.level * (1.0 + GRAZES) if deeper else guard.level


def offs_of(gap: Gap) -> tuple[Guard, ...]:
    """A loose spring falls off where the two are as far apart as it is long."""
    return tuple(Guard("off", "overlap", level=-one.link.reach) for one in gap.loose)


def _guards(gap: Gap, branch: Branch) -> tuple[Guard, ...]:
    law = gap.law
    if gap.touching is not None:
        return (
            (Guard("apart", "force"),) if law is None else law.guards(branch, -gap.room, gap.memory)
        )
    clear = Guard("clear", "overlap")
    if gap.room < 0.0 and law is not None:
        rest = law.resting_overlap(gap.memory)
        if gap.spent:
            return (Guard("touch", "rate", rises=True), Guard("clear", "overlap", level=rest))
        if law.recontacts:
            return (Guard("touch", "push", rises=True), clear)
        if rest > 0.0:
            return (Guard("touch", "overlap", rises=True, level=rest), clear)
    return (Guard("touch", "overlap", rises=True),)


def along(gap: Gap, guard: Guard, over: Poly, force: Poly, rate: Poly | None = None) -> Poly:
    """The quantity of a guard as a series: it falls to zero where the guard's event happens.

    `rate`: of the overlap, where it is not the slope of that series.
    """
    rate = slope(over) if rate is None and guard.of in ("push", "rate") else rate
    if guard.of == "push":
        return _push_to_come(gap, over, rate or [0.0])
    quantity = {"force": force, "overlap": over, "rate": rate or [0.0]}[guard.of]
    if guard.rises:
        return [guard.level - quantity[0], *(-c for c in quantity[1:])]
    return [quantity[0] - guard.level, *quantity[1:]] if guard.level else quantity


def _push_to_come(gap: Gap, over: Poly, rate: Poly) -> Poly:
    """N, negative. What spring and damper of a separated pair would push with."""
    assert gap.law is not None
    k, c = gap.law.stiffness, gap.law.damper(gap.mu)
    pull = [-(k * o + c * r) for o, r in zip(over, rate, strict=False)]
    if abs(pull[0]) <= PUSH_ROUNDING * k * over[0]:
        pull[0] = 0.0
    return pull


def refuse_too_near(gaps: list[Gap], now: Time) -> None:
    """Raise UnsolvedError where two are closer than the force across their gap can be followed."""
    for gap in gaps:
        for link in gap.links:
            if gap.room >= link.nearest or link.nearest == 0.0:
                continue
            raise UnsolvedError(
                said(
                    "at t = {time} s the {effect} are nearer than {least} m: they are too weak to "
                    "keep their carts apart",
                    time=f"{now[0]:.6g}",
                    effect=link.kind,
                    least=f"{link.nearest:g}",
                ),
                said("a larger strength or power, or a lower speed"),
                now[0],
                (),
            )


SAME_GRIP = 1e-12
"""Relative. At the onset of sliding the other forces equal μ_s N. Where that is μ N too, both modes
give the same motion there: friction takes exactly what the others are, and rounding does not decide
whether the body moves. Damped contacts creep to just that edge, and would alternate there."""


def grip(load: Load) -> float:
    """N. The most that static friction is known to hold; more, and the body slides."""
    return load.static * (1.0 + SAME_GRIP) if load.static == load.kinetic else load.static


def reserves(body: Body, others: Poly) -> list[tuple[int, Poly]]:
    """How much more static friction can bear, to the right (1) and to the left (−1)."""
    limit = grip(body.load)
    return [
        (1, [limit - others[0], *(-c for c in others[1:])]),
        (-1, [limit + others[0], *others[1:]]),
    ]
