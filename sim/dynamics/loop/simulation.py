"""What happens in a run, event by event: a touch, a separation, the end of a step, a push.

Each settles the components that it concerns, changes what it has to, lets them form anew and
predicts what comes next around them. Two bodies that fly freely and meet are the common case: they
have a shorter way.
"""

from __future__ import annotations

import math
from collections import defaultdict

from sim.dynamics.loop import collapse, contacts, impacts, release, synchronise, transitions
from sim.dynamics.loop.calendar import Calendar
from sim.dynamics.loop.predictions import Predictions
from sim.dynamics.loop.rooms import no_approach, resting
from sim.dynamics.loop.select_solver import select_solvers
from sim.dynamics.motion.pair_contact import PairContact
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.record import Record
from sim.dynamics.state import flips
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.chain import Chain, component, place, velocity
from sim.dynamics.state.clock import ZERO, Time, elapsed
from sim.dynamics.state.loads import Forces
from sim.scene.model import Scene

MISSED = 5e-9
"""Of the longest cart. Touches are found to rounding; with so much room left the search gave up."""


class Simulation:
    """The state of a run in progress, and the handlers of its events."""

    def __init__(self, scene: Scene, record: Record) -> None:
        self.scene, self.record = scene, record
        self.forces = Forces(scene) if scene.effects else None
        self.chain = Chain(scene, self.forces)
        self.calendar = Calendar(len(self.chain.gaps))
        self.ledger = Ledger(scene)
        self.solvers: defaultdict[str, int] = defaultdict(int)
        self.end: Time = (scene.until, 0.0)
        self.predictions = Predictions(self.chain, self.calendar, self.end)
        self.fastest = 0.0  # m/s, greatest approach so far
        self.instant = flips.AT_ONE_INSTANT * scene.until
        self.hits = collapse.Hits()
        self.happened = self.steps = 0

    def at_gap(self, gap: Gap, now: Time) -> None:
        """What was predicted for a gap happens."""
        if gap.solver is None:
            moving = gap.left.motion is not None or gap.right.motion is not None
            self.chain.advance(gap, now)
            missed = moving and gap.room + resting(gap) > MISSED * self.chain.length
            if missed and not transitions.is_push(gap):
                gap.rate = velocity(gap.right, now) - velocity(gap.left, now)
                self.predictions.gap(gap, now)  # the search came this far: they do not touch yet
                return
            self.begin(gap, now)
        elif isinstance(gap.solver, PairContact):
            self.separate(gap, gap.solver, now)
        else:
            self.motion_ends(gap.left if gap.left.carts else gap.right, now)

    def begin(self, gap: Gap, now: Time) -> None:
        """Two bodies touch."""
        self.happened += 1 if gap.law is None else 2
        free = gap.left.motion is None and gap.right.motion is None
        if self.forces is not None or not free or (gap.law is not None and not gap.law.linear):
            self.join(gap, now)
            return
        if gap.law is None:
            self.strike_free(gap, now)
            return
        self.predictions.bring_around(gap, now)
        place(gap.left, now)
        place(gap.right, now)
        contacts.touch(gap, now, self.record, self.ledger)
        self.solvers["pair-contact"] += 1
        contact = gap.solver = contacts.pair_contact(gap, now)
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
                self.predictions.gap(other, now)

    def strike_free(self, gap: Gap, now: Time) -> None:
        """An impact without duration between two that are free, or several at once."""
        run = collapse.run_of(self.chain, gap, now, self.instant, self.hits)
        if run and any(body.motion is not None for one in run for body in (one.left, one.right)):
            self.join(gap, now)
            return
        struck = run or (gap,)
        for one in struck:
            self.predictions.bring_around(one, now)
            place(one.left, now)
            place(one.right, now)
        self.at_once(gap, now, stays=False)
        if run:
            collapse.together(run, now, self.ledger)
            for body in dict.fromkeys(b for one in run for b in (one.left, one.right)):
                if body.carts:
                    self.record.piece(body)
        for one in struck:
            self.predictions.gap(one, now)
            self.predictions.around(one, now)

    def at_once(self, gap: Gap, now: Time, *, stays: bool) -> None:
        """A contact without duration between two bodies that are free, or settled."""
        self.solvers[gap.contact.law] += 1
        if not gap.contact.joins:
            self.fastest = max(self.fastest, -gap.rate)
            flips.note(gap, now, self.instant)
            impacts.instant(gap, now, self.record, self.ledger, self.fastest, stays=stays)
            return
        impacts.join(self.chain, gap, now, self.record, self.ledger)
        self.predictions.bring_around(gap, now)

    def separate(self, gap: Gap, contact: PairContact, now: Time) -> None:
        """The force of a contact that is alone has become zero."""
        self.happened += 1
        self.predictions.bring_around(gap, now)
        contacts.separate_pair(gap, contact, now, self.record, self.ledger)
        self.predictions.gap(gap, now, own_separation=True)
        self.predictions.around(gap, now)

    def join(self, gap: Gap, now: Time) -> None:
        """A touch of bodies that are not both free: everything that moves them forms anew."""
        rest = resting(gap)
        if now != ZERO and not transitions.is_push(gap):
            gap.room = -rest  # rounding of the search left: that is what a touch is
        motions = (gap.left.motion, gap.right.motion)
        in_contact = any(motion is not None and motion.tier > 0 for motion in motions)
        bodies, gaps = self.settle([gap.left, gap.right], now)
        if gap.left.mass < math.inf or gap.right.mass < math.inf:
            gap.rate = gap.right.v - gap.left.v
            if no_approach(gap, now):
                gap.rate = 0.0
        self.fastest = max(self.fastest, -gap.rate)
        gaps = [*gaps, gap]
        if gap.law is not None:
            flips.note(gap, now, self.instant)
            contacts.touch(gap, now, self.record, self.ledger)
        elif gap.rate <= impacts.AT_REST * self.fastest:  # faster ones part: no impact pulls
            gap.rate = min(gap.rate, 0.0)
            bodies = self.strike(gap, bodies, gaps, now, in_contact=in_contact)
        self.form_again(bodies, gaps, now)

    def strike(
        self, gap: Gap, bodies: list[Body], gaps: list[Gap], now: Time, *, in_contact: bool
    ) -> list[Body]:
        """An impact without duration among settled bodies; returns those that are left."""
        stays = impacts.rests(gap, self.fastest, in_contact=in_contact)
        stays = stays or (self.hits.often(gap) and impacts.hops_within_rounding(gap, now))
        run = [] if stays else collapse.run_of(self.chain, gap, now, self.instant, self.hits)
        if run:
            more, between = self.settle([b for g in run for b in (g.left, g.right)], now)
            bodies = list(dict.fromkeys([*bodies, *more]))
            gaps += [g for g in dict.fromkeys([*between, *run]) if g not in gaps]
        self.at_once(gap, now, stays=stays)
        if run:
            collapse.together(run, now, self.ledger)
        if stays and not gap.joined:
            impacts.rest_together(self.chain, gap, self.ledger)
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
        synchronise.settle(list(row), gaps, now, self.record, self.ledger)
        return list(row), gaps

    def motion_ends(self, body: Body, now: Time) -> None:
        """A cluster's step or a flight is over, or something happened in it."""
        motion = body.motion
        assert motion is not None
        bodies, gaps = self.settle([body], now)
        for gap in motion.members:
            gap.plain = 0 if motion.ends else gap.plain + 1
        self.happened += transitions.leave(motion, now, self.record, self.ledger, self.instant)
        for gap in transitions.struck(motion, self.chain, self.ledger):
            self.happened += 1
            self.fastest = max(self.fastest, -gap.rate)
            bodies = self.strike(gap, bodies, gaps, now, in_contact=True)
        self.form_again(bodies, gaps, now)

    def from_outside(self, number: int, now: Time) -> None:
        """A push begins or ends, or an exploder sets its energy free."""
        forces = self.forces
        assert forces is not None
        if number < len(forces.releases):
            one = forces.releases[number]
            gap = self.chain.gaps[one.gap]
            assert gap is not None
            bodies, gaps = self.settle([gap.left, gap.right], now)
            changed = release.set_free(self.chain, gap, one, now, self.record, self.ledger)
            self.happened += changed
            forces.used[one.kind] += changed
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
        for solver in select_solvers(bodies, gaps, now, self.end, self.forces, self.record):
            self.solvers[solver.name] += 1
            if solver.tier > 1:
                self.steps += 1
            if ready and solver.members:
                self.calendar.gap(solver.members[0], now, solver.duration)
            elif ready:
                self.calendar.body(solver.bodies[0], now, solver.duration)
        for body, before in zip(bodies, held, strict=True):
            if body.held != before and now != ZERO:
                self.record.moment("stop" if body.held else "start", body, now)
                self.happened += 1
        self.predictions.members(bodies, gaps, now)
