"""A row that rattles: one phase of it, from one change of a contact to the next, in closed form.

Bumpers that give back little bounce on their steep line, 1/e times as fast as they were pressed in:
thousands of hops while the row moves on. Each phase, between two changes, is a sum of few modes,
the same ones again and again (`shares`), however many steps a series would take for it; and each
change is found on it (`started`). Where rounding could have the say (a change at once, a contact
that nobody presses, a sign that three coefficients do not tell) the series decides.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from sim.dynamics.motion.guards import guards_of
from sim.dynamics.motion.modes.modal_sum import ModalSum
from sim.dynamics.motion.modes.shares import Block, Swings, swings
from sim.dynamics.motion.modes.started import Grown, Started, UndecidedError, first_fall, grown
from sim.dynamics.motion.series import Row, is_rounding
from sim.dynamics.motion.step import Step
from sim.dynamics.motion.step_ends import NEGLIGIBLE, ONSET
from sim.dynamics.state.body import Body, End, Gap
from sim.dynamics.state.flips import NO_MOTION
from sim.laws.branch import Guard

LONGEST = 32.0
"""Radians of the fastest swing; and of an overlap, the way at its rates up to the end of a phase:
q1 t and the sum of modes cancel to what is left of both, five bits then."""

WHOLE = 1e-13
"""Of the energy-like size of all second derivatives: so well do modes give what they are made of."""


@dataclass(frozen=True, slots=True)
class Phase(Step):
    """Overlaps, forces and velocities as quantities told from their beginning; no polynomials."""

    rates: tuple[complex, ...]
    overlaps: list[Started]  # m
    pushes: list[Started]  # N, of the contacts
    speeds_of: list[Started]  # m/s
    closing: list[Started]  # m/s, rates of the overlaps
    seen: list[tuple[float, Grown]] = field(default_factory=list)
    """The last time asked for: all quantities are asked for at the end of the phase."""

    def at(self, t: float) -> Grown:
        """What the modes have grown to at t s."""
        seen = self.seen
        if not seen or seen[0][0] != t:
            seen[:] = [(t, grown(self.rates, t))]
        return seen[0][1]

    def way(self, i: int, t: float) -> float:
        """m that body i has gone."""
        return self.speeds_of[i].integral(t, self.at(t))

    def velocity(self, i: int, t: float) -> float:
        """m/s of body i."""
        return self.speeds_of[i].value(t, self.at(t))

    def motion(self, i: int, t: float) -> tuple[float, float, float]:
        """Displacement [m], v [m/s], a [m/s²] of body i."""
        v, at = self.speeds_of[i], self.at(t)
        return v.integral(t, at), v.value(t, at), v.rate(at)

    def excess(self, i: int, a: float, dt: float) -> float:
        """m. Displacement of body i from a s on, beyond that at the velocity there."""
        before = self.way(i, a) if a else 0.0
        return self.way(i, a + dt) - before - self.velocity(i, a) * dt

    def speeds(self, i: int, t: float) -> tuple[float, float]:
        """m/s. Least and greatest velocity of body i up to t."""
        v = self.speeds_of[i]
        reach = Started(0.0, v.slope, v.bend, v.shares).size(self.rates, t)
        return v.first - reach, v.first + reach

    def acceleration(self, i: int, t: float) -> float:
        """m/s². Bound for body i up to t."""
        v = self.speeds_of[i]
        swing = sum(
            abs(b) * min(t, 2.0 / abs(z)) for b, z in zip(v.shares, self.rates, strict=True)
        )
        return abs(v.slope) + swing

    def overlap(self, k: int, t: float) -> tuple[float, float]:
        """m and m/s: overlap of gap k and its rate."""
        q, at = self.overlaps[k], self.at(t)
        return q.value(t, at), q.rate(at)

    def contact_force(self, k: int, t: float) -> float:
        """N."""
        return self.pushes[k].value(t, self.at(t))

    def force(self, k: int, t: float) -> tuple[float, float]:
        """N and dN/dt."""
        q, at = self.pushes[k], self.at(t)
        return q.value(t, at), q.rate(at)

    def impulse(self, k: int, t: float) -> float:
        """N s. Of the contact."""
        return self.pushes[k].integral(t, self.at(t))

    def squares(self, i: int, t: float) -> tuple[float, float, float]:
        """There is no drag."""
        return 0.0, 0.0, 0.0

    def rate_square(self, k: int, t: float) -> float:
        """m²/s. Integral of o'² dt in gap k: o' is a sum of modes, and of nothing else."""
        shares = zip(self.rates, self.overlaps[k].shares, strict=True)
        return ModalSum(0.0, tuple((z, y / z) for z, y in shares if y)).square_integral(t)

    def marks(self, end: float) -> list[float]:
        """Every quarter swing of the fastest mode."""
        quarter = 0.5 * math.pi * self.swing
        return [n * quarter for n in range(1, math.ceil(end / quarter))] if quarter else []

    @property
    def swing(self) -> float:
        """s. Of the fastest mode, over 2 pi; 0 where nothing swings."""
        fastest = max(map(abs, self.rates), default=0.0)
        return 1.0 / fastest if fastest else 0.0

    def deepest(self, k: int, t: float, over: float, rate: float) -> float:
        """m. Greatest overlap up to t; `over` and `rate` are those at t."""
        q = self.overlaps[k]
        best = max(q.first, over)
        if q.slope > 0.0 and rate < 0.0:
            turn = first_fall(self.closing[k], self.rates, t)
            if turn is not None:
                best = max(best, q.value(turn, grown(self.rates, turn)))
        return best

    def strongest(self, k: int, t: float) -> float:
        """N. A bound on the contact's force up to t."""
        return self.pushes[k].size(self.rates, t)

    def greatest(self, k: int, t: float) -> list[float]:
        """When a contact's force is greatest: at an end, or where it turns."""
        q, at = self.pushes[k], self.at(t)
        if q.slope > 0.0 and q.rate(at) < 0.0:
            turn = first_fall(slope_of(q, self.rates), self.rates, t)
            if turn is not None:
                return [turn]
        return [t] if q.value(t, at) > q.first else [0.0]


def slope_of(q: Started, rates: tuple[complex, ...]) -> Started:
    """q'."""
    shares = tuple(b * z for b, z in zip(q.shares, rates, strict=True))
    return Started(q.slope, q.bend, sum(b.real for b in shares), shares)


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
    begun = _begun(row, found)
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


@dataclass(frozen=True, slots=True)
class Begun:
    """Derivatives just now: four of each overlap, from o on; three of each N; two of each v, a on.

    They are those of the series, factorials taken out.
    """

    over: list[list[float]]
    force: list[list[float]]
    bodies: list[list[float]]


TERMS = 3
"""Derivatives of forces."""


def _begun(row: Row, found: Swings) -> Begun:
    steady, branches = row.steady, row.branches
    over = [[o, r] for o, r in zip(row.overlaps, row.rates, strict=True)]
    force: list[list[float]] = [[] for _ in over]
    bodies: list[list[float]] = [[] for _ in steady]
    loaded = any(steady)
    for n in range(TERMS):
        for branch, o, push in zip(branches, over, force, strict=True):
            pressed = o[n] if n else o[0] - branch.rest
            push.append(branch.kappa * pressed + branch.gamma * o[n + 1])
        for k, branch in enumerate(branches):
            if branch.locked:
                force[k][n] = _held(k, n, found, force, steady)
        sizes = []
        for own, block in zip(bodies, found.block, strict=True):
            left = force[block.left][n] if block.left is not None else 0.0
            right = force[block.right][n] if block.right is not None else 0.0
            outside = block.load(steady) if n == 0 and loaded else 0.0
            own.append((left - right + outside) * block.inverse)
            sizes.append((abs(left) + abs(right) + abs(outside)) * block.inverse)
        for k, (branch, o) in enumerate(zip(branches, over, strict=True)):
            relative = bodies[k][n] - bodies[k + 1][n]
            if branch.locked or (loaded and is_rounding(relative, sizes[k] + sizes[k + 1])):
                relative = 0.0
            o.append(relative)
    return Begun(over, force, bodies)


def _held(k: int, n: int, found: Swings, force: list[list[float]], steady: list[float]) -> float:
    """N, or its n-th derivative, in a gap that is locked."""
    block, f = found.block[k], found.left_mass[k]
    left = force[block.left][n] if block.left is not None else 0.0
    right = force[block.right][n] if block.right is not None else 0.0
    push = (1.0 - f) * left + f * right
    if n == 0:
        before = math.fsum([steady[i] for i in block.bodies if i <= k])
        after = math.fsum([steady[i] for i in block.bodies if i > k])
        push += (1.0 - f) * before - f * after
    return push


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
    closing = [
        Started(o[1], o[2], o[3], tuple(z * y for z, y in zip(rates, own, strict=True)))
        for o, own in zip(begun.over, shares, strict=True)
    ]
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
        False,
        rates, overlaps, pushes, speeds, closing,
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
            t = first_fall(_guarded(told, k, guard), rates, duration)
            if t is not None:
                if t < duration:
                    ends.clear()
                ends.append(End(guard.cause, k))
                duration = t
    for i, body in enumerate(told.bodies):
        if body.sliding and body.load.static:
            if body.v == 0.0:
                return None
            t = first_fall(_times(told.speeds_of[i], float(body.sliding), 0.0), rates, duration)
            if t is not None:
                if t < duration:
                    ends.clear()
                ends.append(End("halt", i))
                duration = t
    ends.sort(key=lambda end: end.k)
    return ends, duration


def _guarded(told: Phase, k: int, guard: Guard) -> Started:
    """What falls to zero where a guard of gap k has its event."""
    if guard.of == "rate":
        q = told.closing[k]
        swing = told.swing
        if q.first == 0.0 and abs(q.slope) * swing <= ONSET * q.size(told.rates, swing):
            q = Started(0.0, 0.0, q.bend, q.shares)  # as the series does it
    else:
        q = told.pushes[k] if guard.of == "force" else told.overlaps[k]
    return _times(q, -1.0 if guard.rises else 1.0, guard.level)


def _times(q: Started, sign: float, level: float) -> Started:
    """sign (q − level)."""
    first = q.first - level
    if sign > 0.0:
        return Started(first, q.slope, q.bend, q.shares)
    return Started(-first, -q.slope, -q.bend, tuple(-b for b in q.shares))
