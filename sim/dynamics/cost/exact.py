"""The exact outcome of a scene, as cheaply as it can be had, and as truly as it can be known.

Where a scene is one contact of two carts and nothing else, the outcome is the bare formula
(`motion.impact`), and its truth is rational arithmetic. Anything else is a run of the exact
solver, which is then the truth itself.
"""

from __future__ import annotations

import math
from array import array
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from sim.dynamics.loop.run import run
from sim.dynamics.motion.impact import outgoing
from sim.dynamics.result.finished import Run
from sim.dynamics.result.ledger import kinetic
from sim.dynamics.result.trajectory import trajectory
from sim.laws.lookup import contact_law
from sim.scene.model import Scene

ONE_CONTACT = {"contact": 1, "peak": 1, "separate": 1, "end": 1}

Outcome = tuple[tuple[float, ...], tuple[float, ...]]
"""x [m] and v [m/s] of every cart at the end."""


@dataclass(frozen=True)
class Exact:
    """`outcome` computes the end of the scene; `x`, `v` and `energy` [J] are what is true there."""

    outcome: Callable[[], Outcome]
    x: tuple[float, ...]
    v: tuple[float, ...]
    energy: float
    initial: float  # J
    closing: float  # m/s, the greatest approach speed at the start; 0 where nothing closes
    formula: bool  # one contact of two carts: `outcome` is the bare formula
    solved: Run  # with its motion
    proved: bool = False  # x and v are the middles of a certificate, not of a run

    @property
    def in_play(self) -> float:
        """J, the larger of the energies at start and end: that of a spring or magnets may be below
        nought, and a push brings in what was not there. 1 where there is none."""
        return max(abs(self.initial), abs(self.energy)) or 1.0

    @property
    def fastest(self) -> float:
        """m/s, the greatest speed of a cart at any time of the run; 1 where nothing moves."""
        columns = self._columns.items()
        return max(abs(v) for name, values in columns if name[0] == "v" for v in values) or 1.0

    @property
    def rests(self) -> bool:
        """Does every cart stand still at the end, and stay so?"""
        return self.solved.outcome.kind == "came-to-rest"

    @property
    def way(self) -> float:
        """m, how far a cart is at most from where it began; 1 where none has moved."""
        columns = self._columns.items()
        return max(abs(x - at[0]) for name, at in columns if name[0] == "x" for x in at) or 1.0

    @cached_property
    def _columns(self) -> dict[tuple[str, ...], array[float]]:
        """Of the samples of the run: of some runs they take as long as it does."""
        return trajectory(self.solved).columns


def exact(scene: Scene) -> Exact:
    """Solve it once, and choose the cheapest way to do it again."""
    solved = run(scene)
    closing = max(0.0, *(-w for w in scene.approaches if math.isfinite(w)))
    books = solved.ledger
    if _one_contact(scene, dict(solved.record.counts)):
        v, energy = _rational(scene), books.energy_initial
        return Exact(_formula(scene), solved.x, v, kinetic(scene, v), energy, closing, True, solved)

    def again() -> Outcome:
        done = run(scene, keep_events=False, keep_motion=False)
        return done.x, done.v

    x, v, energy = solved.x, solved.v, books.energy_final
    return Exact(again, x, v, energy, books.energy_initial, closing, False, solved)


def _one_contact(scene: Scene, counts: dict[str, int]) -> bool:
    if len(scene.carts) != 2 or scene.effects or scene.contacts[1] is None:
        return False
    law = contact_law(scene.contacts[1])
    linear = law is not None and law.linear
    return linear and counts == ONE_CONTACT and scene.gaps[1] >= 0.0


def _formula(scene: Scene) -> Callable[[], Outcome]:
    """Everything from masses, velocities, gap and law: nothing is prepared but their names."""
    a, b = scene.carts
    m1, m2, v1, v2, x1, x2 = a.mass, b.mass, a.velocity, b.velocity, a.position, b.position
    room, until, contact = scene.gaps[1], scene.until, scene.contacts[1]
    assert contact is not None
    law = contact_law(contact)
    assert law is not None

    def outcome() -> Outcome:
        mu = m1 * m2 / (m1 + m2)
        u = v1 - v2
        figures = law.figures(mu)
        w1, w2 = outgoing(m1, m2, v1, v2, figures.e)
        centre = v1 - mu / m1 * u
        touch = room / u
        rest = until - touch - figures.duration
        shift, out = centre * figures.duration, figures.out_overlap * u
        return (
            x1 + v1 * touch + shift + mu / m1 * out + w1 * rest,
            x2 + v2 * touch + shift - mu / m2 * out + w2 * rest,
        ), (w1, w2)

    return outcome


def _rational(scene: Scene) -> tuple[float, ...]:
    """v' = V + e (V − v) without rounding, then rounded once."""
    a, b = scene.carts
    contact = scene.contacts[1]
    assert contact is not None
    law = contact_law(contact)
    assert law is not None
    m1, m2, v1, v2 = (Fraction(c) for c in (a.mass, b.mass, a.velocity, b.velocity))
    e = Fraction(law.figures(1.0).e)
    centre = (m1 * v1 + m2 * v2) / (m1 + m2)
    return tuple(float(centre + e * (centre - v)) for v in (v1, v2))
