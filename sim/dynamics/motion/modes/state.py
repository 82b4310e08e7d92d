"""A settled row as its place of rest and a sum of modes: every quantity of it in closed form.

With the strains e_k beyond those at the place of rest (`rest`) and w_i the velocities beyond those
of the row as a whole, the share of a mode (lambda, phi, strains eps, norm) is

    a = (sum phi_i m_i w_i − sum kappa_k eps_k e_k / lambda) / norm

Without drag sum phi m w = −sum push_k e_k' / lambda², so that rates of overlaps keep their figures
in a row that moves fast as a whole. A row that nothing holds moves with V0 + A t, or, where drag
acts, about the velocity at which drag and all else balance.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from sim.dynamics.motion.modes.modal_sum import ModalSum, Term
from sim.dynamics.motion.modes.normal_modes import Mode, Segment, modes
from sim.dynamics.motion.power_series.series import SettledRow
from sim.dynamics.motion.rest import Balance, segments, strains
from sim.dynamics.state.body import Body, Gap

WHOLE = 1e-13
"""Of the speed that all energy would give. So well do modes give the state they were made of."""

WELL_TOLD = 1e3
"""Of the speed that all energy would give: the greatest share of one mode. Where two rates nearly
meet, two great shares cancel, and with them as many figures as they are greater."""


@dataclass(frozen=True, slots=True)
class ModalState:
    """Overlaps of the gaps [m], velocities of the bodies [m/s]."""

    over: list[ModalSum]
    speed: list[ModalSum]
    anchored: bool


def modal_state(bodies: list[Body], gaps: list[Gap], row: SettledRow) -> ModalState | None:
    """None where modes do not tell the motion, or not well."""
    fixed = [inv == 0.0 for inv in row.inverse]
    locked = [branch.locked for branch in row.branches]
    stiff, damp = _springs(row)
    if any(k <= 0.0 and not held for k, held in zip(stiff, locked, strict=True)):
        return None
    whole, pull, force = _as_a_whole(bodies, row, fixed)
    pushes = [
        (0.0 if branch.locked else branch.force(over, 0.0))
        + math.fsum([link.force(-over, 0.0) for link in links])
        for branch, over, links in zip(row.branches, row.overlaps, row.links, strict=True)
    ]
    balance = Balance(force, stiff, pushes, fixed, locked)
    strained = strains(balance)
    if strained is None:
        return None
    over = [ModalSum(o - e, ()) for o, e in zip(row.overlaps, strained, strict=True)]
    speed = [ModalSum(0.0, ()) if f else ModalSum(whole, (), pull) for f in fixed]
    state = ModalState(over, speed, any(fixed))
    for own, near in segments(balance):
        segment = _segment(own, near, bodies, row, (stiff, damp))
        if not _add(segment, own, near, row, strained, whole, state):
            return None
    return state if _gives(state, row, bodies, stiff) else None


def _segment(
    own: list[range],
    near: list[int | None],
    bodies: list[Body],
    row: SettledRow,
    springs: tuple[list[float], list[float]],
) -> Segment:
    stiff, damp = ([one[k] if k is not None else 0.0 for k in near] for one in springs)
    return Segment(
        tuple(math.fsum([bodies[i].mass for i in block]) for block in own),
        tuple(math.fsum([row.linear[i] for i in block]) for block in own),
        tuple(stiff),
        tuple(damp),
    )


def _springs(row: SettledRow) -> tuple[list[float], list[float]]:
    """N/m and N s/m of every gap, contact and links."""
    bounds = [
        [link.bounds(-over) for link in links]
        for over, links in zip(row.overlaps, row.links, strict=True)
    ]
    stiff = [
        branch.kappa + math.fsum([k for k, _ in own])
        for branch, own in zip(row.branches, bounds, strict=True)
    ]
    damp = [
        branch.gamma + math.fsum([c for _, c in own])
        for branch, own in zip(row.branches, bounds, strict=True)
    ]
    return stiff, damp


def _as_a_whole(
    bodies: list[Body], row: SettledRow, fixed: list[bool]
) -> tuple[float, float, list[float]]:
    """V [m/s], A [m/s²], and what the balance of the others is left to bear [N]."""
    if any(fixed):
        return 0.0, 0.0, row.steady
    total = math.fsum([body.mass for body in bodies])
    drag = math.fsum(row.linear)
    if drag > 0.0:
        v = math.fsum(row.steady) / drag
        return v, 0.0, [f - b * v for f, b in zip(row.steady, row.linear, strict=True)]
    a = math.fsum(row.steady) / total
    v = math.fsum([body.mass * body.v for body in bodies]) / total
    return v, a, [f - body.mass * a for f, body in zip(row.steady, bodies, strict=True)]


def _add(
    segment: Segment,
    own: list[range],
    near: list[int | None],
    row: SettledRow,
    strained: list[float],
    whole: float,
    state: ModalState,
) -> bool:
    """Put the modes of one segment, of blocks that move as one, into the sums."""
    over, speed = state.over, state.speed
    found = modes(segment) if segment.anchored or len(own) > 1 or any(segment.drags) else ()
    if found is None:
        return False
    strain = [0.0 if k is None else strained[k] for k in near]
    rate = [0.0 if k is None else row.rates[k] for k in near]
    extra = [row.speeds[block[0]] - whole for block in own]
    energy = _energy(segment, strain, extra)
    shares = []
    for mode in found:
        share = _share(mode, segment, strain, rate, extra)
        if share is None or abs(share) ** 2 * _own(mode, segment) > WELL_TOLD**2 * energy:
            return False
        shares.append(share if mode.rate.imag == 0.0 else 2.0 * share)
    terms = list(zip(found, shares, strict=True))
    for j, k in enumerate(near):
        if k is not None:
            over[k] = ModalSum(over[k].constant, _terms([(m, a * m.strain[j]) for m, a in terms]))
    for j, block in enumerate(own):
        swings = _terms([(m, a * m.rate * m.shape[j]) for m, a in terms])
        for i in block:
            speed[i] = ModalSum(speed[i].constant, swings, speed[i].growth)
    return True


def _terms(found: list[tuple[Mode, complex]]) -> tuple[Term, ...]:
    return tuple((mode.rate, a) for mode, a in found)


def _share(
    mode: Mode, segment: Segment, strain: list[float], rate: list[float], extra: list[float]
) -> complex | None:
    z = mode.rate
    if z == 0.0 or mode.norm == 0.0:
        return None
    if any(segment.drags):
        moving = sum(u * m * w for u, m, w in zip(mode.shape, segment.masses, extra, strict=True))
    else:
        moving = -sum(n * r for n, r in zip(mode.push, rate, strict=True)) / (z * z)
    springs = zip(segment.kappa, mode.strain, strain, strict=True)
    return (moving - sum(k * e * s for k, e, s in springs) / z) / mode.norm


def _energy(segment: Segment, strain: list[float], extra: list[float]) -> float:
    """J. Twice that of the motion about the place of rest."""
    moving = [m * w * w for m, w in zip(segment.masses, extra, strict=True)]
    return math.fsum(moving + [k * e * e for k, e in zip(segment.kappa, strain, strict=True)])


def _own(mode: Mode, segment: Segment) -> float:
    """J. Twice the energy of a share of 1."""
    pace = abs(mode.rate) ** 2
    moving = [pace * m * abs(u) ** 2 for m, u in zip(segment.masses, mode.shape, strict=True)]
    held = [k * abs(e) ** 2 for k, e in zip(segment.kappa, mode.strain, strict=True)]
    return math.fsum(moving + held)


def _gives(state: ModalState, row: SettledRow, bodies: list[Body], stiff: list[float]) -> bool:
    """Is the sum at the beginning what the row is? In the energy that what is missing would be."""
    moving = [body.mass for body in bodies if body.mass < math.inf]
    lightest = min(moving)
    motion = [body.mass * body.v * body.v for body in bodies if body.mass < math.inf]
    strained = [
        k * (over.constant**2 + here * here)
        for k, over, here in zip(stiff, state.over, row.overlaps, strict=True)
    ]
    whole = WHOLE**2 * math.fsum(motion + strained)
    overs = zip(stiff, state.over, row.overlaps, strict=True)
    rates = zip((over.slope for over in state.over), row.rates, strict=True)
    speeds = zip(state.speed, row.speeds, strict=True)
    return all(k * (one.value(0.0) - here) ** 2 <= whole for k, one, here in overs) and all(
        lightest * (one.value(0.0) - here) ** 2 <= whole
        for pairs in (rates, speeds)
        for one, here in pairs
    )
