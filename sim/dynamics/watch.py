"""What ends a step of a cluster: quantities that are positive until something happens.

apart   a contact's force is zero               touch   a linked pair reaches its bumpers
turn    a bumper is deepest                     clear   a linked pair's old overlap is gone
climb   it is back at its old depth, or, with   halt    a sliding body comes to v = 0
        e = 0, pressed as hard as at its        slip    static friction has reached its limit
        greatest overlap
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from sim.dynamics.laws import Bumper, Hertz, Paper, PushOnly
from sim.dynamics.outcome import UnsolvedError
from sim.dynamics.polynomial import Poly, slope
from sim.dynamics.pushed_again import PUSH_ROUNDING
from sim.dynamics.series import APART, LOCKED, Branch

if TYPE_CHECKING:
    from sim.dynamics.chain import Body, Gap
    from sim.dynamics.clock import Time

Cause = Literal["apart", "turn", "climb", "touch", "clear", "halt", "slip"]
End = tuple[Cause, int]
"""What happened, and in which gap (the first five) or to which body (the last two)."""


CURVED = Branch(0.0, 0.0, 0.0)
"""No linear branch: the force follows from the law itself (`adaptive`)."""


RIGID = 1e-7
"""Restitution. In a group of contacts, a bumper that springs back less than this is held at its
greatest overlap as one with e = 0 is: followed exactly it would swing 1/e times as fast as all
else. Velocities are off by at most this part of the approach speed; alone, a pair is exact."""


def force_now(gap: Gap, branch: Branch) -> float:
    """N. The contact's force just now; 0 for a locked one."""
    if isinstance(gap.law, Hertz) and gap.touching is not None:
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
    law, d, v, memory = gap.law, -gap.room, -gap.rate, gap.memory
    if law is None:  # an instant contact at rest
        return LOCKED
    if isinstance(law, Bumper):
        # a fresh touch without speed is about to be pressed: there is nothing to spring back yet
        if law.e == 1.0 or (d >= memory and (v > 0.0 or gap.touching.pressing or d == 0.0)):
            return Branch(law.stiffness, 0.0, 0.0)
        if law.e <= RIGID:
            return LOCKED
        return Branch(law.stiffness / law.e**2, 0.0, law.resting_overlap(max(memory, d)))
    if isinstance(law, Hertz):
        return CURVED
    assert isinstance(law, (Paper, PushOnly))
    return Branch(law.stiffness, law.damper(gap.mu), 0.0)


def contact(gap: Gap, branch: Branch, over: Poly, force: Poly) -> list[tuple[Cause, Poly]]:
    """What ends the branch of a touching gap when it falls to zero."""
    law = gap.law
    if law is None:
        return [("apart", force)]
    if isinstance(law, (Paper, Hertz)):
        return [("apart", over)]
    if not isinstance(law, Bumper) or law.e == 1.0:
        return [("apart", force)]
    if branch.locked:
        spare = [law.stiffness * over[0] - force[0], *(-c for c in force[1:])]
        return [("apart", force), ("climb", spare)]
    if branch.kappa == law.stiffness:
        return [("apart", force), ("turn", slope(over))]
    return [("apart", force), ("climb", [gap.memory - over[0], *(-c for c in over[1:])])]


def refuse_too_near(gaps: list[Gap], now: Time) -> None:
    """Raise UnsolvedError where two are closer than the force across their gap can be followed."""
    for gap in gaps:
        for link in gap.links:
            if gap.room >= link.nearest or link.nearest == 0.0:
                continue
            raise UnsolvedError(
                f"at t = {now[0]:.6g} s the {link.kind} are nearer than {link.nearest:g} m: they "
                "are too weak to keep their carts apart",
                "a larger strength or power, or a lower speed",
                now[0],
                (),
            )


def linked(gap: Gap, over: Poly) -> list[tuple[Cause, Poly]]:
    """A pair that is linked but does not touch: until it touches.

    A bumper that has not cleared touches at its resting overlap, a push-only pair when its force
    turns positive, unless it clears first.
    """
    rest = 0.0
    if gap.room < 0.0 and isinstance(gap.law, PushOnly):
        k, c = gap.law.stiffness, gap.law.damper(gap.mu)
        pull = [-(k * o + c * rate) for o, rate in zip(over, slope(over), strict=False)]
        if abs(pull[0]) <= PUSH_ROUNDING * k * over[0]:
            pull[0] = 0.0
        return [("touch", pull), ("clear", over)]
    if gap.room < 0.0 and gap.law is not None:
        rest = gap.law.resting_overlap(gap.memory)
    found: list[tuple[Cause, Poly]] = [("touch", [rest - over[0], *(-c for c in over[1:])])]
    return [*found, ("clear", over)] if rest > 0.0 else found


def grip(body: Body, others: Poly) -> list[Poly]:
    """How much more, to the right and to the left, static friction can bear."""
    limit = body.load.static
    return [
        [limit - others[0], *(-c for c in others[1:])],
        [limit + others[0], *others[1:]],
    ]
