"""The right-hand side of a scene: from displacements and velocities to accelerations, built once.

    m_k a_k = N_(k−1) − N_k + pulls + friction        N_k [N] pushes the bodies of gap k apart

`s` holds the displacement of each cart from its start [m], so that gaps do not suffer from large
positions; `v` its velocity [m/s]. Numbers may be floats, or arrays of many runs at once (`lanes`).
Carts that stick together (velcro, a latch) move as one body.

Friction has no direction at rest, and a step jumps over rest. So a cart slower than what friction
takes in one step, |v| <= μ N h/m, counts as stopping: friction then takes up all other forces, up
to μ_s N, and what is left of the motion. Stops and starts are late or early by up to one step.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from typing import Any

from sim.dynamics.stepping.joint_forces import from_walls, joint_forces
from sim.dynamics.stepping.pairs import Detail, Pair, PerCart, link_force, pair_of
from sim.dynamics.stepping.regrouped import at_wall, bodies_of, regroup
from sim.effects.forces import FRICTION, BodyForce, checked
from sim.laws.stepping import Mode
from sim.scene.model import Scene


class Field:
    """Forces of one scene. `keep` collects the details of each evaluation while it is a list."""

    def __init__(self, scene: Scene, lanes: int = 0) -> None:
        self.scene, self.lanes = scene, lanes
        self.count = len(scene.carts)
        self.mass = [cart.mass for cart in scene.carts]
        self.inverse = [1.0 / mass for mass in self.mass]
        self._acting = checked(scene)
        self.pairs = [
            pair
            for k in range(self.count + 1)
            if (pair := pair_of(scene, k, self._acting)) is not None
        ]
        self.pair_at = {pair.gap: pair for pair in self.pairs}
        self.memory: list[Any] = [self.number() for _ in range(self.count + 1)]
        self.modes: dict[int, Mode] | None = None  # by gap, where events are located
        self.sliding: dict[int, int] = {}  # by body, likewise: −1, 0 (held) or 1
        self.force_time: float | None = None  # s, inside a step that no switch falls into
        self.joined: set[int] = set()  # gaps whose bodies move as one
        self.held: set[int] = set()  # those of them that a pressed bumper keeps, see `held`
        self.spent: set[int] = set()  # gaps whose bumpers a release has parted, see `spent`
        self.bodies = bodies_of(self.count, self.joined)
        self.grips = self._grips()
        self.releases = sorted(
            (one for effect in self._acting for one in effect.releases()), key=lambda one: one.time
        )
        self.switches = sorted(
            {t for one in self._acting for t in one.switches() if 0.0 < t < math.inf}
        )
        self._body_forces = [self._from(t) for t in [0.0, *self.switches]]
        self.loaded = any(force for segment in self._body_forces for force in segment)
        self.linked = any(pair.links for pair in self.pairs)
        self.evaluations = 0
        self.keep: list[Detail] | None = None

    def number(self) -> Any:
        """Nought, in all lanes."""
        if not self.lanes:
            return 0.0
        import numpy as np

        return np.zeros(self.lanes)

    def _grips(self) -> list[tuple[float, float]] | None:
        found = [
            [grip for one in self._acting if (grip := one.friction(k)) is not None]
            for k in range(self.count)
        ]
        if not any(found):
            return None
        return [(sum(g.kinetic for g in f), sum(g.static for g in f)) for f in found]

    def _from(self, t: float) -> list[list[BodyForce]]:
        return [
            [force for one in self._acting if (force := one.body_force(k, t)) is not None]
            for k in range(self.count)
        ]

    def overlap(self, pair: Pair, s: PerCart, v: PerCart) -> tuple[Any, Any]:
        """d [m], negative where there is room, and its rate [m/s]."""
        i, j = pair.left, pair.right
        if i is None:
            return -s[j] - pair.room, -v[j]  # type: ignore[index]
        if j is None:
            return s[i] - pair.room, v[i]
        return s[i] - s[j] - pair.room, v[i] - v[j]

    def accelerations(self, t: Any, s: PerCart, v: PerCart, h: Any) -> PerCart:
        """m/s² at t s; h [s] is the step that they are for, or for located events any number."""
        self.evaluations += 1
        push, links, total = self.forces(t, s, v)
        if self.grips is None and not self.joined:
            a = [force * inv for force, inv in zip(total, self.inverse, strict=True)]
            rub: dict[tuple[str, int], float] = {}
        else:
            a, rub = self.moved(total, v, h)
        if self.keep is not None:
            outside = self._outside(t, v) | rub
            joints: dict[int, float] = {}
            if self.joined:
                outside |= from_walls(self, total)
                joints = joint_forces(self, total, rub, a)
                for gap in self.held:
                    push[gap] = joints.pop(gap)
            taken = self._taken(push, s, v)
            self.keep.append(Detail(push, links, joints, outside, *taken, list(v)))
        return a

    def forces(
        self, t: Any, s: PerCart, v: PerCart
    ) -> tuple[PerCart, dict[tuple[str, int], Any], PerCart]:
        """N: by contacts per gap, by springs and magnets, and all on each cart but friction."""
        push: PerCart = [0.0] * (self.count + 1)
        links: dict[tuple[str, int], Any] = {}
        for pair in self.pairs:
            gap = pair.gap
            held = gap in self.held  # by its bumper: what else acts across it acts on
            if gap in self.joined and not held:
                continue
            d, rate = self.overlap(pair, s, v)
            force = pair.force
            if force is None or held or gap in self.spent:
                pass
            elif self.modes is not None:
                push[gap] = force.on(self.modes[gap], d, rate, self.memory[gap])
            elif self.lanes:
                push[gap] = force.pushes(d, rate, self.memory[gap])
            else:
                push[gap] = force.push(d, rate, self.memory[gap])
            for link in pair.links:
                links[link.kind, gap] = links.get((link.kind, gap), 0.0) + link_force(
                    link, d, rate, lanes=bool(self.lanes)
                )
        return push, links, self._total(t, v, push, links)

    def _total(
        self, t: Any, v: PerCart, push: PerCart, links: dict[tuple[str, int], float]
    ) -> PerCart:
        """N on each cart, friction left out."""
        if links:
            between = list(push)
            for (_, gap), force in links.items():
                between[gap] = between[gap] + force
        else:
            between = push
        total = [between[k] - between[k + 1] for k in range(self.count)]
        if self.loaded:
            for k, speed in enumerate(v):
                for one in self.body_forces(t)[k]:
                    total[k] = total[k] + one.at(speed)
        return total

    def body_forces(self, t: float) -> list[list[BodyForce]]:
        """By cart, just after t; while `force_time` is set, as then."""
        if not self.switches:
            return self._body_forces[0]
        return self._body_forces[
            bisect_right(self.switches, t if self.force_time is None else self.force_time)
        ]

    def moved(
        self, total: PerCart, v: PerCart, h: Any
    ) -> tuple[PerCart, dict[tuple[str, int], float]]:
        """Accelerations of bodies that may stick together, and what friction does to each cart."""
        a: PerCart = [0.0] * self.count
        rub: dict[tuple[str, int], float] = {}
        for body in self.bodies:
            if self.fixed(body):
                continue
            mass, force = sum(self.mass[k] for k in body), sum(total[k] for k in body)
            if self.grips is not None:
                grip = (
                    sum(self.grips[k][0] for k in body),
                    sum(self.grips[k][1] for k in body),
                )
                friction, slides = self._friction(body[0], mass, v[body[0]], force, grip, h)
                force += friction
                each, whole = (0, grip[0]) if slides else (1, grip[1])
                for k in body:  # what rests is shared as each could bear it
                    rub[FRICTION, k] = friction * self.grips[k][each] / whole if whole else 0.0
            for k in body:
                a[k] = force / mass
        return a, rub

    def _friction(
        self, body: int, mass: float, v: float, others: float, grip: tuple[float, float], h: float
    ) -> tuple[float, bool]:
        """N, and whether it is that of a body which slides."""
        kinetic, static = grip
        if self.modes is not None:
            side = self.sliding[body]
            return (-side * kinetic, True) if side else (-others, False)
        if abs(v) > kinetic * h / mass:
            return -math.copysign(kinetic, v), True
        if abs(others) <= static:
            return -others - v * mass / h, False
        return -math.copysign(kinetic, others), True

    def _outside(self, t: float, v: PerCart) -> dict[tuple[str, int], float]:
        found: dict[tuple[str, int], float] = {}
        for k, forces in enumerate(self.body_forces(t)):
            for one in forces:
                found[one.kind, k] = found.get((one.kind, k), 0.0) + one.at(v[k])
        return found

    def _taken(self, push: PerCart, s: PerCart, v: PerCart) -> tuple[float, dict[str, float]]:
        """W. By the dampers of contacts, and of springs by kind."""
        warming = 0.0
        damped: dict[str, float] = {}
        for pair in self.pairs:
            if pair.gap in self.joined:
                continue
            d, rate = self.overlap(pair, s, v)
            if pair.force is not None:
                warming += pair.force.warming(push[pair.gap], d, rate)
            for link in pair.links:
                damped[link.kind] = damped.get(link.kind, 0.0) + link.damping() * rate * rate
        return warming, damped

    def fixed(self, body: Sequence[int]) -> bool:
        """Does it stick to a wall?"""
        return at_wall(body, self.joined, self.count)

    def join(self, gap: int, *, part: bool = False) -> None:
        """From now on the bodies of a gap move as one; `part`: no longer."""
        if part:
            self.joined.discard(gap)
        else:
            self.joined.add(gap)
        self.bodies = bodies_of(self.count, self.joined)
        regroup(self.pairs, self.mass, self.joined - self.held)
