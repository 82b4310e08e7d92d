"""A row that rattles: one phase of it after another in closed form, each up to its end.

Bumpers that give back little bounce on their steep line, 1/e times as fast as they were pressed in:
thousands of hops while the row moves on. Each phase, between two changes, is a sum of few modes,
the same ones again and again (`shares`), however many steps a series would take for it; and each
change is found on it (`started`). Where rounding could have the say (a change at once, a contact
that nobody presses, a sign that three coefficients do not tell) the series decides.
"""

from __future__ import annotations

import math
from operator import mul

from sim.dynamics.motion.guards import guards_of, passed
from sim.dynamics.motion.modes.begun import Begun, begun_of
from sim.dynamics.motion.modes.falls import UndecidedError, first_fall
from sim.dynamics.motion.modes.phase import Phase
from sim.dynamics.motion.modes.shares import Block, Swings, swings
from sim.dynamics.motion.modes.started import Started, Swinging, swinging
from sim.dynamics.motion.power_series.series import SettledRow
from sim.dynamics.motion.power_series.step_ends import NEGLIGIBLE, ONSET
from sim.dynamics.state.body import Body, End, Gap
from sim.dynamics.state.flips import NO_MOTION
from sim.laws.branch import Guard
from sim.laws.rounding import LAST_BIT

LONGEST = 32.0
"""Radians of the fastest swing; and of an overlap, the way at its rates up to the end of a phase:
q1 t and the sum of modes cancel to what is left of both, five bits then."""

TOGETHER = LAST_BIT
"""Relative. Two ends nearer in time than the search tells come at once, as where gaps on both sides
of a cart part: taken one after the other the second would cost a step without motion."""

WHOLE = 1e-13
"""Of all second derivatives, weighed as energies: so well do modes give what they are made of."""


def phase(
    bodies: list[Body], gaps: list[Gap], row: SettledRow, limit: float
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
    modes = _amplitudes(row, found, begun)
    if modes is None:
        return None
    length = min(limit, _well_told(begun, found, modes))
    if found.fastest > 0.0:
        length = min(length, LONGEST / found.fastest)
    current = _phase_of(bodies, gaps, row, found, begun, modes, length)
    try:
        ends = _first_ends(current)
    except UndecidedError:
        return None
    if ends is None or ends[1] <= NO_MOTION * current.swing:
        return None
    return current, *ends


def _amplitudes(row: SettledRow, found: Swings, begun: Begun) -> Swinging | None:
    """Of all modes, from two derivatives of each overlap; None where they do not give those."""
    second = [o[2] for o in begun.over]
    third = [o[3] for o in begun.over]
    amplitudes = []
    for parts in found.parts:
        a = 0j
        for one in parts:
            a += one.of_strain * second[one.gap] + one.of_rate * third[one.gap]
        amplitudes.append(a)
    whole, off, pace = 0.0, 0.0, found.pace
    for k, branch in enumerate(row.branches):
        if kappa := branch.kappa:
            two, three = second[k], third[k]
            here = two - sum(map(mul, amplitudes, found.over[k].of)).real
            turned = three - sum(map(mul, amplitudes, found.closing[k].of)).real
            off = max(off, kappa * (here**2 + (turned / pace) ** 2))
            whole += kappa * (two**2 + (three / pace) ** 2)
    return swinging(found.rates, tuple(amplitudes)) if off <= WHOLE**2 * whole else None


def _well_told(begun: Begun, found: Swings, modes: Swinging) -> float:
    """s. How long the overlaps are told well."""
    longest = math.inf
    for o, shape, ways in zip(begun.over, found.over, found.ways, strict=True):
        fast = sum(map(mul, modes.sizes, ways))
        if fast > 0.0:
            swing = sum(map(mul, modes.sizes, shape.size_in_value))
            longest = min(longest, LONGEST * (abs(o[0]) + swing) / fast)
    return longest


def _phase_of(
    bodies: list[Body],
    gaps: list[Gap],
    row: SettledRow,
    found: Swings,
    begun: Begun,
    modes: Swinging,
    length: float,
) -> Phase:
    """All quantities of the phase."""
    overlaps = [
        Started(o[0], o[1], o[2], own) for o, own in zip(begun.over, found.over, strict=True)
    ]
    pushes = [
        Started(n[0], n[1], n[2], own) for n, own in zip(begun.force, found.push, strict=True)
    ]
    speeds = [
        Started(_common(bodies, block) or body.v, a[0], a[1], own)
        for body, block, a, own in zip(bodies, found.block, begun.bodies, found.speed, strict=True)
    ]
    return Phase(
        bodies, gaps, row.branches, length, begun.over, [], [], [], [], row.steady,
        False, found, modes, overlaps, pushes, speeds,
    )  # fmt: skip


def _common(bodies: list[Body], block: Block) -> float:
    """m/s. Of those that move as one: what rounding made of their velocities when they locked."""
    if len(block.bodies) == 1 or not block.inverse:
        return 0.0
    return block.inverse * math.fsum([bodies[i].mass * bodies[i].v for i in block.bodies])


def _first_ends(current: Phase) -> tuple[list[End], float] | None:
    """As `step_ends.first_ends`; None where the series is to decide."""
    modes, duration = current.modes, current.length
    soon = current.swing or duration
    sizes = [
        abs(push.first) + (abs(push.slope) + abs(push.bend) * soon) * soon
        for push in current.pushes
    ]
    noise = NEGLIGIBLE * max(sizes)
    ends: list[End] = []
    for k in current.found.stiffest:  # what comes first is found first: less is left to search
        gap, branch = current.gaps[k], current.branches[k]
        if sizes[k] <= noise or (branch.locked and gap.rate > 0.0) or gap.touching is None:
            return None
        for guard in guards_of(gap, branch):
            if guard.of == "push":
                return None
            sign = -1.0 if guard.rises else 1.0
            here, beyond = _guarded(current, k, guard), passed(guard)
            until = duration * (1.0 + TOGETHER)
            if beyond != guard.level and first_fall(here, modes, until, sign, beyond) is None:
                continue  # it comes just as deep as before
            t = first_fall(here, modes, until, sign, guard.level)
            if t is not None:
                if t < duration * (1.0 - TOGETHER):
                    ends.clear()
                ends.append(End(guard.cause, k))
                duration = min(t, duration)
    for i, body in enumerate(current.bodies):
        if body.sliding and body.load.static:
            if body.v == 0.0:
                return None
            t = first_fall(current.speeds_of[i], modes, duration, float(body.sliding))
            if t is not None:
                if t < duration:
                    ends.clear()
                ends.append(End("halt", i))
                duration = t
    ends.sort(key=lambda end: (end.cause == "halt", end.k))  # as the series tells them
    return ends, duration


def _guarded(current: Phase, k: int, guard: Guard) -> Started:
    """What falls, or rises, to the level of a guard of gap k where its event happens."""
    if guard.of == "force":
        return current.pushes[k]
    if guard.of == "overlap":
        return current.overlaps[k]
    q, swing = current.closing(k), current.swing
    if q.first == 0.0 and abs(q.slope) * swing <= ONSET * q.size(current.modes, swing):
        return Started(0.0, 0.0, q.bend, q.shape)  # as the series does it
    return q
