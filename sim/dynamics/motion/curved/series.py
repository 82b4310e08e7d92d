"""Power series of a row in which some contacts are those of spheres, in their own time s.

With w = dt/ds = unit z³ of the contact that keeps the clock (`own_time`; w = 1 where none does)
every unknown X has dX/ds = w X', so that its coefficients follow from those before them by products
of series (`force_series`). A step is a part of the radius of convergence that the last terms show.
Contacts that are `silent` are left out (`group`). Source: Jorba & Zou, A software package
for the numerical integration of ODEs by means of high-order Taylor methods, Experimental
Mathematics 14 (2005) 99.
"""

from __future__ import annotations

import math
from typing import Protocol, runtime_checkable

from sim.dynamics.motion.curved.force_series import (
    Clock,
    ClockContact,
    LinearContact,
    Links,
    PressedContact,
    dot,
)
from sim.dynamics.motion.curved.own_time import OwnTime
from sim.dynamics.motion.curved.step import CurvedStep
from sim.dynamics.motion.curved_field import curved
from sim.dynamics.motion.locked import hold, locked_runs
from sim.dynamics.motion.power_series.polynomial import Poly, value
from sim.dynamics.motion.power_series.series import (
    CONVERGED,
    ORDER,
    SettledRow,
    add_drag,
    is_rounding,
    root,
)
from sim.dynamics.state.body import Body, Gap
from sim.laws.branch import APART

SPARSE = 10
"""Of two spheres by themselves z has the terms s, s^11, s^21 …: of so many in a row one tells."""


@runtime_checkable
class OfRoot(Protocol):
    """A contact law that is a polynomial in z = d^(1/4) and d'."""

    def of_root(self, mu: float) -> tuple[float, float]:
        """K and C of N = K z^6 + C z d'."""


class RowSeries:
    """All unknowns of a row by their coefficients in s."""

    def __init__(
        self, row: SettledRow, gaps: list[Gap], clock: int | None, unit: float, silent: list[int]
    ) -> None:
        self.row, self.gaps, self.place, self.silent = row, gaps, clock, silent
        z = None if clock is None else math.sqrt(math.sqrt(row.overlaps[clock]))
        self.clock = Clock(z, unit)
        self.contacts = [self._contact(k) for k in range(len(gaps))]
        self.links = [Links(links, gap.room) for links, gap in zip(row.links, gaps, strict=True)]
        self.runs = locked_runs(row.branches)
        self.o, self.r = [[d] for d in row.overlaps], [[rate] for rate in row.rates]
        # what stands is told from the beginning: two products less at every coefficient
        moves = [inv != 0.0 or v != 0.0 for inv, v in zip(row.inverse, row.speeds, strict=True)]
        self.v = [
            [v] if moving else [v] + [0.0] * ORDER
            for v, moving in zip(row.speeds, moves, strict=True)
        ]
        self.path = [[0.0] if moving else [0.0] * (ORDER + 1) for moving in moves]
        self.a: list[Poly] = [[] for _ in row.speeds]
        self.force: list[Poly] = [[] for _ in gaps]
        self.pull: list[Poly] = [[] for _ in gaps]
        self.relative: list[Poly] = [[] for _ in gaps]
        self.t = [0.0]
        self.loaded = any(row.steady) or any(row.linear) or any(row.quadratic)
        told = zip(self.path, self.v, self.a, moves, strict=True)
        self.moving = [(path, v, a) for path, v, a, moving in told if moving]
        for n in range(ORDER):
            self._next(n)

    def _contact(self, k: int) -> LinearContact | ClockContact | PressedContact:
        law = curved(self.gaps[k])
        if law is None or k in self.silent:
            return LinearContact(APART if law is not None else self.row.branches[k])
        assert isinstance(law, OfRoot)
        stiff, damper = law.of_root(self.gaps[k].mu)
        if k == self.place:
            return ClockContact(stiff, damper, self.clock)
        return PressedContact(stiff, damper)

    def _next(self, n: int) -> None:
        """The coefficients that follow from those up to n."""
        self.clock.move(n)
        late, part = self.clock.w[::-1], 1.0 / (n + 1)
        for k, contact in enumerate(self.contacts):
            if k == self.place and n:
                self.o[k].append(dot(self.clock.square, self.clock.square[::-1]))
            self.force[k].append(contact.coefficient(n, self.o[k], self.r[k]))
            if self.row.links[k]:
                self.pull[k].append(self.links[k].coefficient(n, self.o[k], self.r[k]))
        relative = self._accelerations(n)
        self.t.append(part * self.clock.w[n])
        for path, v, a in self.moving:
            path.append(part * dot(v, late))
            v.append(part * dot(a, late))
        for k, over in enumerate(self.o):
            if k != self.place:
                over.append(part * dot(self.r[k], late))
            else:
                self.clock.z.append(0.25 * self.clock.unit * part * self.r[k][n])
            self.r[k].append(part * dot(relative[k], late))

    def _accelerations(self, n: int) -> list[Poly]:
        """The n-th ones of all bodies; returns those of the overlaps up to n."""
        row, force, pull = self.row, self.force, self.pull
        outside = [0.0] * len(row.inverse) if n else list(row.steady)
        add_drag(row, self.v, outside, n)
        for k, links in enumerate(row.links):
            if links:
                outside[k] -= pull[k][n]
                outside[k + 1] += pull[k][n]
        for run in self.runs:
            hold(run, force, row.inverse, outside, n)
        sizes = []
        for i, inv in enumerate(row.inverse):
            left = force[i - 1][n] if i > 0 else 0.0
            right = force[i][n] if i < len(force) else 0.0
            self.a[i].append((left - right + outside[i]) * inv)
            sizes.append((abs(left) + abs(right) + abs(outside[i])) * inv)
        for k, branch in enumerate(row.branches):
            one = self.a[k][n] - self.a[k + 1][n]
            if branch.locked or (self.loaded and is_rounding(one, sizes[k] + sizes[k + 1])):
                one = 0.0
            self.relative[k].append(one)
        return self.relative

    def converged(self, limit: float) -> float:
        """The span in which all series have converged to rounding; about `limit` s where all have
        at once."""
        found = math.inf
        watched = [p for k, p in enumerate(self.o) if k != self.place]
        for p in (*watched, self.clock.z, *self.v):
            first = next((n for n, c in enumerate(p) if c != 0.0), len(p))
            for n in range(len(p) - SPARSE, len(p)):
                if n > first and p[n] != 0.0:
                    radius = root(abs(p[first]) / abs(p[n]), n - first)
                    found = min(found, CONVERGED * radius)
        if found == math.inf:
            found = 1.0
            while value(self.t, found) < limit:
                found *= 2.0
        return found

    def step(self, bodies: list[Body], span: float) -> CurvedStep:
        """The step up to `span`."""
        gaps, row = self.gaps, self.row
        own = OwnTime(self.t, math.inf, math.inf).until(span)
        over = list(self.o)
        if self.place is not None:
            over[self.place] = self.clock.z
        nothing: Poly = [0.0]
        squares = [
            self._over_time(_square(r))
            if branch.gamma or any(link.damping() for link in gap.links)
            else nothing
            for r, branch, gap in zip(self.r, row.branches, gaps, strict=True)
        ]
        return CurvedStep(
            bodies, gaps, row.branches, own.length, over, self.force, self.pull, self.v, self.path,
            row.steady, False, self.place, own, self.r, self.a,
            [self._over_time(n) for n in self.force],
            [self._over_time(_product(c.damping, self.r[k])) for k, c in enumerate(self.contacts)],
            squares,
            [self._drags(i, body) for i, body in enumerate(bodies)],
            [self._over_time(n) for n in self.pull],
            [self._over_time(self.o[k]) if gap.loose else nothing for k, gap in enumerate(gaps)],
        )  # fmt: skip

    def _drags(self, i: int, body: Body) -> list[Poly]:
        """Integrals of v², v|v| and |v|³, as far as drag asks for them."""
        if not (body.load.linear or body.load.quadratic):
            return []
        square, direction = _square(self.v[i]), float(body.sliding)
        cube = _product(square, self.v[i]) if body.load.quadratic else [0.0]
        return [
            self._over_time(square),
            self._over_time([direction * c for c in square]),
            self._over_time([direction * c for c in cube]),
        ]

    def _over_time(self, p: Poly) -> Poly:
        """The integral of p over the time, from the beginning of the step."""
        if not p:
            return [0.0]
        return [0.0, *(c / n for n, c in enumerate(_product(p, self.clock.w), 1))]


def _product(p: Poly, q: Poly) -> Poly:
    """The product of two series, as far as the shorter one goes."""
    return [dot(p[: n + 1], q[n::-1]) for n in range(min(len(p), len(q)))]


def _square(p: Poly) -> Poly:
    return _product(p, p)
