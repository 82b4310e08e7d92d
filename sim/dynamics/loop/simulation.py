"""What happens in a run, event by event: a touch, a separation, the end of a step, a push.

Each settles the components that it concerns, changes what it has to, lets them form anew and
predicts what comes next around them. Two bodies that fly freely and meet are the common case: they
have a shorter way.
"""

from __future__ import annotations

import math
from collections import defaultdict

from sim.dynamics.loop import (
    contacts as resolve,
)
from sim.dynamics.loop import (
    release as bursts,
)
from sim.dynamics.loop import (
    synchronise as components,
)
from sim.dynamics.loop import (
    transitions as ending,
)
from sim.dynamics.loop.calendar import Calendar
from sim.dynamics.loop.detect import next_touch, no_approach, resting, touch_in_motion
from sim.dynamics.loop.select_solver import form
from sim.dynamics.motion.coupled_group import Cluster
from sim.dynamics.motion.flight import Flight
from sim.dynamics.motion.linear_pair import PairPhase
from sim.dynamics.motion.pair_contact import PairContact
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.record import Record
from sim.dynamics.state.chain import Body, Chain, Gap, component, moved, velocity
from sim.dynamics.state.clock import ZERO, Time, elapsed
from sim.dynamics.state.loads import Forces
from sim.scene.model import Scene

MISSED = 1e-9
"""m. A touch is found to 1e-16 m; where that much room is left, the search ran out of steps."""


class Happenings:
    """The state of a run in progress, and what may happen to it."""

    def __init__(self, scene: Scene, record: Record) -> None:
        self.scene, self.record = scene, record
        self.forces = Forces(scene) if scene.effects else None
        self.chain = Chain(scene, self.forces)
        self.calendar = Calendar(len(self.chain.gaps))
        self.ledger = Ledger(scene)
        self.solvers: defaultdict[str, int] = defaultdict(int)
        self.end: Time = (scene.until, 0.0)
        self.fastest = 0.0  # m/s, greatest approach so far
        self.happened = 0
        self.steps = 0

    def at_gap(self, gap: Gap, now: Time) -> None:
        """What was predicted for a gap happens."""
        if gap.solver is None:
            moving = gap.left.motion is not None or gap.right.motion is not None
            self.chain.advance(gap, now)
            if moving and gap.room + resting(gap) > MISSED and not ending.is_push(gap):
                gap.rate = velocity(gap.right, now) - velocity(gap.left, now)
                self.predict(gap, now)  # the search came this far, and they do not touch yet
                return
            self.begin(gap, now)
        elif isinstance(gap.solver, PairContact):
            self.separate(gap, now)
        else:
            self.step(gap.left if gap.left.carts else gap.right, now)

    def predict(self, gap: Gap, now: Time, own_separation: bool = False) -> None:
        """When does this gap close? The gap is up to date."""
        if gap.left.motion is None and gap.right.motion is None:
            self.calendar.gap(gap, now, next_touch(gap, now, own_separation))
        else:
            self.calendar.gap(gap, now, touch_in_motion(gap, now, self.end, own_separation))

    def around(self, gap: Gap, now: Time) -> None:
        """Bring the neighbouring gaps up to date before the bodies of `gap` change."""
        for other in self.chain.neighbours(gap):
            if other is not None and other.solver is None:
                self.chain.advance(other, now)

    def predict_around(self, gap: Gap, now: Time) -> None:
        """The bodies of `gap` have changed: their other neighbours may touch at another time."""
        for other in self.chain.neighbours(gap):
            if other is not None and other.solver is None:
                other.rate = velocity(other.right, now) - velocity(other.left, now)
                self.predict(other, now)

    def place(self, body: Body, now: Time) -> None:
        """Bring a free body's position to `now`."""
        if body.carts:
            body.x += moved(body, body.time, now)
            body.time = now

    def begin(self, gap: Gap, now: Time) -> None:
        """Two bodies touch."""
        self.happened += 1 if gap.law is None else 2
        free = gap.left.motion is None and gap.right.motion is None
        if self.forces is not None or not free or (gap.law is not None and not gap.law.linear):
            self.join(gap, now)
            return
        self.around(gap, now)
        self.place(gap.left, now)
        self.place(gap.right, now)
        if gap.law is None:
            self.at_once(gap, now, stays=False)
            self.predict(gap, now)
            self.predict_around(gap, now)
            return
        resolve.touch(gap, now, self.record, self.ledger)
        self.solvers["pair-contact"] += 1
        contact = gap.solver = resolve.pair_contact(gap, now)
        for body in (gap.left, gap.right):
            if body.carts:  # a wall can be in two contacts: it does not move in either
                body.motion = contact
                self.record.piece(body)
        self.calendar.gap(gap, now, contact.duration)
        for other in self.chain.neighbours(gap):
            if other is not None and other.solver is None:
                # Velocities do not jump at a touch, but a neighbour in a contact has moved on.
                if other.left.motion is not None and other.right.motion is not None:
                    other.rate = velocity(other.right, now) - velocity(other.left, now)
                self.predict(other, now)

    def at_once(self, gap: Gap, now: Time, *, stays: bool) -> None:
        """A contact without duration between two bodies that are free, or settled."""
        self.solvers[gap.contact.law] += 1
        if not gap.contact.joins:
            self.fastest = max(self.fastest, -gap.rate)
            resolve.instant(gap, now, self.record, self.ledger, self.fastest, stays=stays)
            return
        resolve.join(self.chain, gap, now, self.record, self.ledger)
        for other in self.chain.neighbours(gap):
            if other is not None and other.solver is None:
                self.chain.advance(other, now)

    def separate(self, gap: Gap, now: Time) -> None:
        """The force of a contact that is alone has become zero."""
        self.happened += 1
        self.around(gap, now)
        resolve.separate_pair(gap, now, self.record, self.ledger)
        self.predict(gap, now, own_separation=True)
        self.predict_around(gap, now)

    def join(self, gap: Gap, now: Time) -> None:
        """A touch of bodies that are not both free: everything that moves them forms anew."""
        rest = resting(gap)
        if not ending.is_push(gap):
            gap.room = -rest  # rounding of the search left: that is what a touch is
        in_contact = any(
            isinstance(b.motion, (PairContact, PairPhase, Cluster)) for b in (gap.left, gap.right)
        )
        bodies, gaps = self.settle([gap.left, gap.right], now)
        if gap.left.mass < math.inf or gap.right.mass < math.inf:
            gap.rate = gap.right.v - gap.left.v
            if no_approach(gap, now):
                gap.rate = 0.0
        self.fastest = max(self.fastest, -gap.rate)
        gaps = [*gaps, gap]
        if gap.law is not None:
            resolve.touch(gap, now, self.record, self.ledger)
        else:
            bodies = self.strike(gap, bodies, gaps, now, in_contact=in_contact)
        self.form_again(bodies, gaps, now)

    def strike(
        self, gap: Gap, bodies: list[Body], gaps: list[Gap], now: Time, *, in_contact: bool
    ) -> list[Body]:
        """An impact without duration among settled bodies; returns those that are left."""
        stays = resolve.rests(gap, self.fastest, in_contact=in_contact)
        self.at_once(gap, now, stays=stays)
        if stays and not gap.joined:
            resolve.rest_together(self.chain, gap, self.ledger)
        for other in gaps:
            if other is not gap and not other.joined:
                other.rate = other.right.v - other.left.v
                if other.law is None and other.rate != 0.0:
                    other.touching = None  # it rested; now it opens, or is struck in its turn
        return [body for body in bodies if self.chain.bodies[body.carts[0]] is body]

    def settle(self, bodies: list[Body], now: Time) -> tuple[list[Body], list[Gap]]:
        """Settle the components of these bodies; the free gaps around them are brought to `now`.

        Returns all their bodies and member gaps, from left to right.
        """
        row: dict[Body, None] = {}  # by identity, in order
        gaps: list[Gap] = []
        for body in bodies:
            if body.carts and body not in row:
                more, between = component(self.chain, body)
                row |= dict.fromkeys(more)
                gaps += between
        for body in row:
            for index in (body.left, body.right):
                other = self.chain.gaps[index]
                if other is not None and other.solver is None:
                    self.chain.advance(other, now)
        components.settle(list(row), gaps, now, self.record, self.ledger)
        return list(row), gaps

    def step(self, body: Body, now: Time) -> None:
        """A cluster's step or a flight is over, or something happened in it."""
        solver = body.motion
        bodies, gaps = self.settle([body], now)
        if isinstance(solver, (Cluster, PairPhase)):
            self.happened += ending.leave(solver, now, self.record, self.ledger)
            for gap in ending.struck(solver):
                self.happened += 1
                self.fastest = max(self.fastest, -gap.rate)
                bodies = self.strike(gap, bodies, gaps, now, in_contact=True)
        else:
            body.v = 0.0
        self.form_again(bodies, gaps, now)

    def from_outside(self, number: int, now: Time) -> None:
        """A push begins or ends, or an exploder sets its energy free."""
        forces = self.forces
        assert forces is not None
        if number < len(forces.releases):
            release = forces.releases[number]
            gap = self.chain.gaps[release.gap]
            assert gap is not None
            bodies, gaps = self.settle([gap.left, gap.right], now)
            changed = bursts.set_free(self.chain, gap, release, now, self.record, self.ledger)
            self.happened += changed
            forces.used[release.kind] += changed
            bodies = [b for b in dict.fromkeys([*bodies, gap.left, gap.right]) if b.carts]
            self.form_again(bodies, [*gaps, gap], now)
            return
        forces.move_to(now[0])
        bodies, gaps = self.settle(list(dict.fromkeys(self.chain.bodies)), now)
        self.form_again(bodies, gaps, now)

    def form_again(self, bodies: list[Body], gaps: list[Gap], now: Time) -> None:
        """What still belongs together gets new solvers; everything around is predicted anew."""
        bodies = sorted(bodies, key=lambda body: body.carts)
        ready = elapsed(now, self.end) > 0.0
        held = [body.held for body in bodies]
        for body in bodies:
            self.calendar.void(body)
        for solver in form(bodies, gaps, now, self.end, self.forces, self.record):
            self.solvers[solver.name] += 1
            if isinstance(solver, Cluster):
                self.steps += 1
            if not ready:
                continue
            if isinstance(solver, PairContact):
                first = self.chain.gaps[solver.gap]
                assert first is not None
                self.calendar.gap(first, now, solver.duration)
            elif isinstance(solver, (Cluster, PairPhase)) and solver.members:
                self.calendar.gap(solver.members[0], now, solver.duration)
            else:
                body = solver.body if isinstance(solver, Flight) else solver.bodies[0]
                self.calendar.body(body, now, solver.duration)
        for body, before in zip(bodies, held, strict=True):
            if body.held != before and now != ZERO:
                self.record.moment("stop" if body.held else "start", body, now)
                self.happened += 1
        self.predict_all(bodies, gaps, now)

    def predict_all(self, bodies: list[Body], gaps: list[Gap], now: Time) -> None:
        """Void what was predicted for members; predict every free gap of these bodies."""
        found: dict[int, Gap] = {}
        for body in bodies:
            for index in (body.left, body.right):
                other = self.chain.gaps[index]
                if other is not None:
                    found[index] = other
        for gap in found.values():
            solver = gap.solver
            if isinstance(solver, Cluster) and gap is not solver.members[0]:
                gap.turn += 1  # the cluster's events stand under its first gap
            elif solver is None and not gap.joined:
                mine = gap in gaps
                if not mine:
                    gap.rate = velocity(gap.right, now) - velocity(gap.left, now)
                self.predict(gap, now, own_separation=mine)
