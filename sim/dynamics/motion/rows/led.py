"""A stiff contact whose swing has faded, beside forces that change slowly: led, not swinging.

Two carts that a strong damper holds at 1e-9 m of overlap while drag slows both, or a magnet pushes
the row, have nothing fast left in them. Yet a step of the plain series may be no longer than their
swing would be. Here overlap and force of such a contact follow from the motion, not it from them:

    a_left − a_right = o''              the row as if it were rigid, but for o''
    kappa (o − rest) + gamma o' = N     solved for o: o_n = (N_n − gamma (n + 1) o_(n+1))/kappa

Begun with o'' = 0, each round of the two brings about 1/(w h)², or gamma/(kappa h), of what the one
before it brought; w is the rate of the contact and h the radius of convergence of what remains.
A damped spring across the gap, with a contact or without, is one branch with it.
The series is that of the one solution without a swing (the slow manifold; Fenichel, J. Diff.
Equations 31 (1979) 53). The row is on it where overlaps and rates differ from it by no more than
QUIET, as at rest (`rest`); that difference, 3e-13 of the force and fading, is left out.
"""

from __future__ import annotations

import math
from dataclasses import replace

from sim.dynamics.motion.power_series.polynomial import Poly, integral, size
from sim.dynamics.motion.power_series.series import (
    Expansion,
    SettledRow,
    converged_step,
    expand,
    step_length,
)
from sim.dynamics.motion.power_series.step import Step
from sim.dynamics.motion.rest import QUIET
from sim.dynamics.state.body import Body, Gap
from sim.laws.branch import LOCKED, Branch
from sim.laws.rounding import LAST_BIT

WORTH = 6.0
"""Steps of the plain series that one led step has to be worth."""

STIFFER = 8.0
"""Times the rate of the next softer contact: from there on contacts are led."""

ROUNDS = 16

AGREE = 1e-16
"""Of the accelerations in the step. Rounds that differ by less give the same bits."""


def led_step(bodies: list[Body], gaps: list[Gap], row: SettledRow, limit: float) -> Step | None:
    """The longer step of a row whose stiff contacts have nothing left of their swing; else None."""
    plain, row = row, _with_springs_as_contacts(gaps, row)
    if any(body.held for body in bodies) or not (stiff := _stiff(row)):
        return None
    rigid = [LOCKED if k in stiff else branch for k, branch in enumerate(row.branches)]
    if _is_clamped(row, rigid):
        return None
    slow = replace(row, branches=rigid)
    longest = min(step_length(slow), limit)
    found = _followed(slow, row, stiff, longest)
    if found is None:
        return None
    series, over, length = found
    if length < WORTH * step_length(row) or not _is_on_it(row, over, stiff, step_length(row)):
        return None
    speed = [[b.v, *integral(a)[1:]] for b, a in zip(bodies, series.bodies, strict=True)]
    for k, (before, now) in enumerate(zip(plain.links, row.links, strict=True)):
        if before != now:
            total, contact = series.force[k], _force(plain.branches[k], over[k])
            series.pull[k] = [t - c for t, c in zip(total, contact, strict=False)]
            series.force[k] = contact
    return Step(
        bodies, gaps, plain.branches, length, over, series.force, series.pull, speed, [],
        row.steady, short=False,
    )  # fmt: skip


def _with_springs_as_contacts(gaps: list[Gap], row: SettledRow) -> SettledRow:
    """The same row, where springs across a gap are one branch with its contact: it leads too."""
    branches, links = list(row.branches), list(row.links)
    for k, (gap, branch, own) in enumerate(zip(gaps, row.branches, row.links, strict=True)):
        if own and not branch.locked and all(link.linear for link in own):
            bounds = [link.bounds(gap.room) for link in own]
            kappa = math.fsum([branch.kappa, *(stiff for stiff, _ in bounds)])
            gamma = math.fsum([branch.gamma, *(damping for _, damping in bounds)])
            o = row.overlaps[k]
            push = branch.force(o, 0.0) + math.fsum(link.force(gap.room, 0.0) for link in own)
            if kappa > 0.0:
                branches[k], links[k] = Branch(kappa, gamma, o - push / kappa), ()
    return replace(row, branches=branches, links=links)


def _force(branch: Branch, over: Poly) -> Poly:
    """kappa (o − rest) + gamma o', without the last coefficient, which o' does not have."""
    rest = [branch.rest, *[0.0] * (len(over) - 2)]
    return [
        branch.kappa * (o - r) + branch.gamma * (n + 1) * after
        for n, (o, r, after) in enumerate(zip(over, rest, over[1:], strict=False))
    ]


def _stiff(row: SettledRow) -> set[int]:
    """The contacts that are stiffer by far than all others, without a spring or magnet beside."""
    rates: list[tuple[float, int]] = []
    for k, (branch, links) in enumerate(zip(row.branches, row.links, strict=True)):
        if branch.kappa > 0.0:
            rate = math.sqrt(branch.kappa * (row.inverse[k] + row.inverse[k + 1]))
            rates.append((0.0 if links else rate, k))
    if not rates:
        return set()
    rates.sort(reverse=True)
    slower = [*(rate for rate, _ in rates[1:]), 0.0]
    parts = [
        fast / slow if slow else math.inf for (fast, _), slow in zip(rates, slower, strict=True)
    ]
    last = max(range(len(parts)), key=lambda j: parts[j])
    if parts[last] < STIFFER or rates[last][0] == 0.0:
        return set()
    return {k for _, k in rates[: last + 1]}


def _is_clamped(row: SettledRow, rigid: list[Branch]) -> bool:
    """Is a rigid part of the row held at both ends? Then its forces do not follow from motion."""
    fixed = 0
    for k, branch in enumerate(rigid):
        if not branch.locked:
            fixed = 0
            continue
        if k == 0 or not rigid[k - 1].locked:
            fixed = row.inverse[k] == 0.0
        fixed += row.inverse[k + 1] == 0.0
        if fixed > 1:
            return True
    return False


def _followed(
    slow: SettledRow, row: SettledRow, stiff: set[int], longest: float
) -> tuple[Expansion, list[Poly], float] | None:
    """All series, overlaps, and a step in which they converge; None: the rounds do not agree."""
    led: list[Poly] = [[] for _ in row.branches]
    last = math.inf
    for _ in range(ROUNDS):
        series = expand(slow, led)
        speed = [[v, *integral(a)[1:]] for v, a in zip(row.speeds, series.bodies, strict=True)]
        length = converged_step(slow, series, [*speed, *series.force], longest)
        over, change, scale = list(series.over), 0.0, 0.0
        for k in stiff:
            push, own = series.force[k], row.inverse[k] + row.inverse[k + 1]
            over[k] = _overlap(push, row, k)
            second = _second(over[k])
            before = led[k] or [0.0] * len(second)
            differ = [a - b for a, b in zip(second, before, strict=True)]
            change = max(change, size(differ, length))
            scale = max(scale, size(push, length) * own)
            led[k] = second
        if change <= AGREE * scale:
            return series, over, length
        if not change < last:  # the motion is too quick for the contact to be led
            return None
        last = change
    return None


def _overlap(push: Poly, row: SettledRow, k: int) -> Poly:
    """kappa (o − rest) + gamma o' = N, from the last coefficient to the first."""
    branch = row.branches[k]
    found, after = [], 0.0
    for n in range(len(push) - 1, -1, -1):
        after = (push[n] - branch.gamma * (n + 1) * after) / branch.kappa
        found.append(after)
    found.reverse()
    found[0] += branch.rest
    return found


def _second(over: Poly) -> Poly:
    """o'', as long as N is."""
    return [(n + 1) * (n + 2) * c for n, c in enumerate(over[2:])] + [0.0, 0.0]


def _is_on_it(row: SettledRow, over: list[Poly], stiff: set[int], step: float) -> bool:
    """Do overlaps and rates of the stiff contacts belong to a motion without a swing?"""
    deepest = max(abs(over[k][0] - row.branches[k].rest) for k in stiff)
    longest = max(abs(row.overlaps[k]) for k in stiff)  # of a spring: its length, with its rounding
    quiet = QUIET * deepest + LAST_BIT * longest
    return all(
        abs(over[k][0] - row.overlaps[k]) <= quiet
        and abs(over[k][1] - row.rates[k]) * step <= quiet
        for k in stiff
    )
