"""Tier 3: what has neither a closed form nor a power series is integrated, with located events.

    y = overlaps, their rates, velocities, ways, impulses and losses of the contacts
    y' = f(y) by an embedded Runge-Kutta method of order 8 (Dormand & Prince, scipy's DOP853)

One accepted step at a time; its dense output (degree 7) serves for events and drawing as a power
series does. Where an event ends the step, the step is done again up to there, so that the state at
the event has the method's full order and not the dense output's. Tolerances: see below. numpy and
scipy are imported here, when first used, and only here. Source: Hairer, Nørsett & Wanner, Solving
Ordinary Differential Equations I, II.5 and II.6.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

from sim.dynamics.motion.coupled_group import Cluster
from sim.dynamics.motion.polynomial import Poly, value
from sim.dynamics.motion.series import Expansion, hold_now
from sim.dynamics.result.outcome import UnsolvedError
from sim.effects.forces import resistance

RELATIVE = 1e-12
"""Error per step, relative: a hundred steps of a contact stay within 1e-10."""

SMALL = 1e-13
"""The same relative to the greatest speed, and to the way gone in a contact at that speed."""


@dataclass(slots=True)
class Adaptive(Cluster):
    """One step of a row in which some contact has a curved law."""

    impulses: list[Poly] = field(init=False)
    losses: list[Poly] = field(init=False)
    name = "adaptive"
    tier = 3

    def _solve(self) -> None:
        self.row = self._row([0.0] * len(self.bodies))
        self.duration = self._step(self.limit)

    def _find_ends(self) -> None:
        before = self.duration
        Cluster._find_ends(self)
        if 0.0 < self.duration < before:
            self._step(self.duration)

    def _sizes(self) -> list[float]:
        """Every force counts: none of these rows is long."""
        return [math.inf] * len(self.members)

    def _slope(self, y: list[float]) -> list[float]:
        """f(y)."""
        count, bodies = len(self.members), self.bodies
        over, rate, v = y[:count], y[count : 2 * count], y[2 * count : 2 * count + len(bodies)]
        push, loss, pull = [], [], []
        for k, gap in enumerate(self.members):
            law, branch = gap.law, self.branches[k]
            if law is not None and not law.linear and self.touched[k]:
                push.append(law.force(gap.mu, over[k], rate[k]))
                loss.append(law.dissipated(gap.mu, over[k], rate[k]))
            else:
                push.append(branch.force(over[k], rate[k]))
                loss.append(branch.gamma * rate[k] * rate[k])
            pull.append(math.fsum(link.force(-over[k], -rate[k]) for link in gap.links))
        outside = []
        for i, body in enumerate(bodies):
            load = body.load
            force = self.row.steady[i] + resistance(load.linear, load.quadratic, v[i])
            force += pull[i - 1] if i > 0 else 0.0
            outside.append(force - (pull[i] if i < count else 0.0))
        hold_now(self.branches, push, self.row.inverse, outside)
        a = [
            ((push[i - 1] if i > 0 else 0.0) - (push[i] if i < count else 0.0) + outside[i]) * inv
            for i, inv in enumerate(self.row.inverse)
        ]
        relative = [0.0 if self.branches[k].locked else a[k] - a[k + 1] for k in range(count)]
        return [*rate, *relative, *a, *v, *push, *loss]

    def _step(self, limit: float) -> float:
        """Take one accepted step, at most `limit` s, and keep its dense output."""
        count, n = len(self.members), len(self.bodies)
        start = [*self.row.overlaps, *self.row.rates, *self.row.speeds]
        start += [0.0] * (n + 2 * count)
        if limit <= 0.0:
            self._keep([[y] for y in start])
            return 0.0
        numpy, dop853 = _scipy()
        solver = dop853(
            lambda _t, y: self._slope(y.tolist()),
            0.0,
            numpy.array(start),
            limit,
            rtol=RELATIVE,
            atol=numpy.array(self._tolerances()),
        )
        solver.step()
        if solver.status == "failed":
            raise UnsolvedError(
                "the contact is too stiff to be integrated",
                "a softer stiffness, or law: bumper, which has a closed form",
                self.begun[0],
                (),
            )
        self._keep(_polynomials(solver))
        return float(solver.t)

    def _tolerances(self) -> list[float]:
        """Absolute ones, from the greatest speed and the time of a contact at that speed."""
        count = len(self.members)
        masses = [body.mass for body in self.bodies if body.mass < math.inf]
        speed = max([abs(v) for v in (*self.row.speeds, *self.row.rates)], default=0.0) or 1e-6
        stiff = max(
            [
                gap.law.stiffness
                for gap in self.members
                if gap.law is not None and not gap.law.linear
            ],
            default=1.0,
        )
        way = speed * (min(masses) ** 2 / (stiff**2 * speed)) ** 0.2
        way = max([way, *(abs(o) for o in self.row.overlaps if abs(o) < way)])
        bodies = len(self.bodies)
        return (
            [SMALL * way] * count
            + [SMALL * speed] * (count + bodies)
            + [SMALL * way] * bodies
            + [SMALL * min(masses) * speed] * count
            + [SMALL * min(masses) * speed * speed] * count
        )

    def _keep(self, dense: list[Poly]) -> None:
        count, n = len(self.members), len(self.bodies)
        over = dense[:count]
        self.speed = dense[2 * count : 2 * count + n]
        self.path = dense[2 * count + n : 2 * count + 2 * n]
        self.impulses = dense[2 * count + 2 * n : 3 * count + 2 * n]
        self.losses = dense[3 * count + 2 * n :]
        force = [[k * c for k, c in enumerate(p)][1:] or [0.0] for p in self.impulses]
        nothing = [0.0] * max(len(p) for p in force) if force else [0.0]
        still = [[0.0] * len(nothing) for _ in self.bodies]
        self.series = Expansion(over, force, [list(nothing) for _ in over], still)

    def impulse(self, k: int, t: float) -> float:
        """N s, integrated with the motion."""
        return value(self.impulses[k], t)

    def contact_force(self, k: int, t: float) -> float:
        """N, by the law itself."""
        gap, over = self.members[k], self.series.over[k]
        rate = [n * c for n, c in enumerate(over)][1:]
        if gap.law is not None and not gap.law.linear and self.touched[k]:
            return gap.law.force(gap.mu, value(over, t), value(rate, t))
        return self.branches[k].force(value(over, t), value(rate, t))

    def force(self, gap: int, tau: float) -> tuple[float, float]:
        """N by the law, dN/dt by the dense output."""
        k = next(k for k, own in enumerate(self.members) if own.index == gap)
        _, growth = Cluster.force(self, gap, tau)
        room = -value(self.series.over[k], tau)
        linked = math.fsum(link.force(room, 0.0) for link in self.members[k].links)
        return self.contact_force(k, tau) + linked, growth

    def warmed(self, k: int, t: float) -> float:
        """J, integrated with the motion; what a bumper keeps follows from its law."""
        law = self.members[k].law
        if law is not None and not law.linear:
            return value(self.losses[k], t)
        return Cluster.warmed(self, k, t)


def _scipy() -> tuple[Any, Any]:
    try:
        import numpy
        from scipy.integrate import DOP853
    except ImportError as missing:
        raise UnsolvedError(
            "the contact law hertz needs the packages numpy and scipy, which this page does not "
            "carry",
            "write packages: [scipy] into the scene block",
            0.0,
            (),
        ) from missing
    return numpy, DOP853


def _polynomials(solver: Any) -> list[Poly]:
    """Dense output of the last step as coefficients of 1, t, t² …, one list per component.

    scipy keeps y = y0 + x (F0 + (1 − x)(F1 + x (F2 + …))), x = t/h.
    """
    import numpy

    dense = solver.dense_output()
    total = numpy.zeros((len(dense.y_old), 1))
    for place, term in enumerate(reversed(dense.F)):
        total[:, 0] += term
        longer = numpy.zeros((len(total), total.shape[1] + 1))
        longer[:, 1:] = total if place % 2 == 0 else -total
        if place % 2:
            longer[:, :-1] += total
        total = longer
    total[:, 0] += dense.y_old
    scale = dense.h ** -numpy.arange(total.shape[1], dtype=float)
    return [[float(c) for c in row] for row in total * scale]
