"""A row that rattles: one phase of it after another in closed form, each up to its end.

Bumpers that give back little bounce on their steep line, 1/e times as fast as they were pressed in:
thousands of hops while the row moves on. Each phase, between two changes, is a sum of few modes,
the same ones again and again (`shares`), however many steps a series would take for it; and each
change is found on it (`started`). Where rounding could have the say (a change at once, a contact
that nobody presses, a sign that three coefficients do not tell) the series decides.
"""

from __future__ import annotations

import math

from sim.dynamics.motion.guards import guards_of
from sim.dynamics.motion.modes.begun import Begun, begun_of
from sim.dynamics.motion.modes.phase import Phase
from sim.dynamics.motion.modes.shares import Block, Swings, swings
from sim.dynamics.motion.modes.started import Started, UndecidedError, first_fall
from sim.dynamics.motion.series import Row
from sim.dynamics.motion.step_ends import NEGLIGIBLE, ONSET
from sim.dynamics.state.body import Body, End, Gap
from sim.dynamics.state.flips import NO_MOTION
from sim.laws.branch import Guard

LONGEST = 32.0
"""Radians of the fastest swing; and of an overlap, the way at its rates up to the end of a phase:
q1 t and the sum of modes cancel to what is left of both, five bits then."""

WHOLE = 1e-13
"""Of all second derivatives, weighed as energies: so well do modes give what they are made of."""


def phase(
    bodies: list[Body], gaps: list[Gap], row: Row, limit: float
) -> tuple[Phase, list[End], float] | None:
    """The phase of a settled row, what ends it, and when [s]; None where a series is called for."""
    plain = not (row.nonlinear or any(row.linear) or any(row.links))
    if not plain or any(body.held for body in bodies):
        return None
    found = swings(
        tuple(1.0 / inv if inv else math.inf for inv in row.inverse),
        tuple(branch.kappa for branch in row.branches),
        tuple(branch.gamma for branch in row.branches),
        tuple(branch.locked for branch in row.branches),
    )
    if found is None:
        return None
    begun = begun_of(row, found)
    shares = _shares(row, found, begun)
    if shares is None:
        return None
    swings_on = max((abs(z) for z in found.rates if z.imag), default=0.0)
    length = min(limit, _well_told(begun, found, shares))
    if swings_on > 0.0:
        length = min(length, LONGEST / swings_on)
    told = _told(bodies, gaps, row, found, begun, shares, length)
    try:
        ends = _first_ends(told)
    except UndecidedError:
        return None
    if ends is None or ends[1] <= NO_MOTION * told.swing:
        return None
    return told, *ends


def _shares(row: Row, found: Swings, begun: Begun) -> list[tuple[complex, ...]] | None:
    """Of o'' of each gap, mode by mode; None where they do not give it."""
    second = [o[2] for o in begun.over]
    third = [o[3] for o in begun.over]
    shares = [[0j] * len(found.rates) for _ in second]
    for j, parts in enumerate(found.parts):
        a = 0j
        for one in parts:
            a += one.of_strain * second[one.gap] + one.of_rate * third[one.gap]
        for one in parts:
            shares[one.gap][j] = a * one.strain
    whole, off, pace = 0.0, 0.0, max(map(abs, found.rates), default=1.0)
    for k, branch in enumerate(row.branches):
        here = second[k] - sum(y.real for y in shares[k])
        turned = sum((z * y).real for z, y in zip(found.rates, shares[k], strict=True))
        off = max(off, branch.kappa * (here**2 + ((third[k] - turned) / pace) ** 2))
        whole += branch.kappa * (second[k] ** 2 + (third[k] / pace) ** 2)
    return [tuple(own) for own in shares] if off <= WHOLE**2 * whole else None


def _well_told(begun: Begun, found: Swings, shares: list[tuple[complex, ...]]) -> float:
    """s. How long the overlaps are told well."""
    longest = math.inf
    for o, own in zip(begun.over, shares, strict=True):
        ways = [abs(y / z) for y, z in zip(own, found.rates, strict=True)]
        fast = sum(ways)
        if fast > 0.0:
            swing = sum(w / abs(z) for w, z in zip(ways, found.rates, strict=True))
            longest = min(longest, LONGEST * (abs(o[0]) + swing) / fast)
    return longest


def _told(
    bodies: list[Body],
    gaps: list[Gap],
    row: Row,
    found: Swings,
    begun: Begun,
    shares: list[tuple[complex, ...]],
    length: float,
) -> Phase:
    """All quantities of the phase."""
    rates = found.rates
    overlaps = [Started(o[0], o[1], o[2], own) for o, own in zip(begun.over, shares, strict=True)]
    nothing = (0j,) * len(rates)
    bent: list[tuple[complex, ...]] = []  # N''
    for branch, own in zip(row.branches, shares, strict=True):
        kappa, gamma = branch.kappa, branch.gamma
        bent.append(
            tuple((kappa + gamma * z) * y for z, y in zip(rates, own, strict=True))
            if gamma
            else tuple(kappa * y for y in own)
        )
    for k, branch in enumerate(row.branches):
        if branch.locked:
            block, f = found.block[k], found.left_mass[k]
            left = bent[block.left] if block.left is not None else nothing
            right = bent[block.right] if block.right is not None else nothing
            bent[k] = tuple((1.0 - f) * a + f * b for a, b in zip(left, right, strict=True))
    pushes = [Started(n[0], n[1], n[2], own) for n, own in zip(begun.force, bent, strict=True)]
    speeds = []
    for body, block, a in zip(bodies, found.block, begun.bodies, strict=True):
        left = bent[block.left] if block.left is not None else nothing
        right = bent[block.right] if block.right is not None else nothing
        part = block.inverse
        own = (
            tuple([(x - y) * part / z for x, y, z in zip(left, right, rates, strict=True)])
            if part
            else nothing
        )
        speeds.append(Started(_common(bodies, block) or body.v, a[0], a[1], own))
    return Phase(
        bodies, gaps, row.branches, length, begun.over, [], [], [], [], row.steady,
        False, rates, overlaps, pushes, speeds, [o[3] for o in begun.over],
    )  # fmt: skip


def _common(bodies: list[Body], block: Block) -> float:
    """m/s. Of those that move as one: what rounding made of their velocities when they locked."""
    if len(block.bodies) == 1 or not block.inverse:
        return 0.0
    return block.inverse * math.fsum([bodies[i].mass * bodies[i].v for i in block.bodies])


def _first_ends(told: Phase) -> tuple[list[End], float] | None:
    """As `step_ends.first_ends`; None where the series is to decide."""
    rates, duration = told.rates, told.length
    soon = told.swing or duration
    sizes = [
        abs(push.first) + (abs(push.slope) + abs(push.bend) * soon) * soon for push in told.pushes
    ]
    noise = NEGLIGIBLE * max(sizes)
    ends: list[End] = []
    stiffest = sorted(range(len(sizes)), key=lambda k: -told.branches[k].kappa)
    for k in stiffest:  # what comes first is found first: less is left to search
        gap, branch = told.gaps[k], told.branches[k]
        if sizes[k] <= noise or (branch.locked and gap.rate > 0.0) or gap.touching is None:
            return None
        for guard in guards_of(gap, branch):
            if guard.of == "push":
                return None
            sign = -1.0 if guard.rises else 1.0
            t = first_fall(_guarded(told, k, guard), rates, duration, sign, guard.level)
            if t is not None:
                if t < duration:
                    ends.clear()
                ends.append(End(guard.cause, k))
                duration = t
    for i, body in enumerate(told.bodies):
        if body.sliding and body.load.static:
            if body.v == 0.0:
                return None
            t = first_fall(told.speeds_of[i], rates, duration, float(body.sliding))
            if t is not None:
                if t < duration:
                    ends.clear()
                ends.append(End("halt", i))
                duration = t
    ends.sort(key=lambda end: (end.cause == "halt", end.k))  # as the series tells them
    return ends, duration


def _guarded(told: Phase, k: int, guard: Guard) -> Started:
    """What falls, or rises, to the level of a guard of gap k where its event happens."""
    if guard.of == "force":
        return told.pushes[k]
    if guard.of == "overlap":
        return told.overlaps[k]
    q, swing = told.closing(k), told.swing
    if q.first == 0.0 and abs(q.slope) * swing <= ONSET * q.size(told.rates, swing):
        return Started(0.0, 0.0, q.bend, q.shares)  # as the series does it
    return q
