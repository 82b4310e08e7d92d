"""The run: detect the next event, advance to it, resolve it, record it.

Tier 0, free flight, and tier 1, one contact at a time, are closed forms; tier 2, contacts that
share bodies, is a power series. The calendar holds one prediction per gap; a prediction that an
event has overtaken is void and skipped.
"""

from __future__ import annotations

import heapq
import math
from collections import Counter

from sim.dynamics import components, ledger, resolve
from sim.dynamics.chain import Body, Chain, Gap, moved, velocity
from sim.dynamics.clock import ZERO, Time, later
from sim.dynamics.cluster import Cluster
from sim.dynamics.contact import PairContact
from sim.dynamics.detect import next_touch, touch_during_contact
from sim.dynamics.finished import Run, outcome_of
from sim.dynamics.ledger import Ledger
from sim.dynamics.outcome import refuse_what_is_not_solved
from sim.dynamics.record import Record
from sim.scene.model import Scene

MOST_EVENTS = 1_000_000
"""A run stops after this many events unless told otherwise: some scenes have infinitely many."""

STEPS_PER_EVENT = 10
"""A contact of several carts takes a handful of steps; a run that needs ten times as many as it may
have events is one that never ends."""


def run(
    scene: Scene,
    *,
    max_events: int = MOST_EVENTS,
    keep_events: bool = True,
    keep_motion: bool = True,
) -> Run:
    """Run a scene exactly. Raises UnsolvedError where no exact solver is at hand."""
    return _Run(scene, max_events, Record(scene, keep_events, keep_motion)).finish()


class _Run:
    """The state of one run in progress."""

    def __init__(self, scene: Scene, max_events: int, record: Record) -> None:
        refuse_what_is_not_solved(scene)
        self.scene, self.max_events, self.record = scene, max_events, record
        self.chain = Chain(scene)
        self.ledger = Ledger()
        self.solvers: Counter[str] = Counter()
        self.calendar: list[tuple[float, float, int, int]] = []
        self.fastest = max(abs(cart.velocity) for cart in scene.carts)
        self.happened = 0
        self.steps = 0
        record.pieces = [[] for _ in scene.carts]
        for body in self.chain.bodies:
            self.solvers["free-flight"] += 1
            record.piece(body)
        for gap in self.chain.gaps:
            if gap is None:
                continue
            if gap.room < 0.0 and gap.law is not None:
                self.begin(gap, ZERO)
            elif gap.touching is None:
                self.predict(gap, ZERO)

    def finish(self) -> Run:
        end: Time = (self.scene.until, 0.0)
        calendar, gaps = self.calendar, self.chain.gaps
        full = False
        while calendar and calendar[0][0] <= end[0]:
            hi, lo, index, turn = heapq.heappop(calendar)
            gap = gaps[index]
            if gap is None or gap.turn != turn:
                continue
            if self.happened >= self.max_events or self.steps >= STEPS_PER_EVENT * self.max_events:
                full, end = True, (hi, lo)
                break
            now = (hi, lo)
            if gap.touching is None:
                self.chain.advance(gap, now)
                self.begin(gap, now)
            elif isinstance(gap.touching.solver, PairContact):
                self.separate(gap, now)
            else:
                self.step(gap, now)
        return self.result(end, full)

    def schedule(self, gap: Gap, now: Time, dt: float) -> None:
        """Put the gap's next event into the calendar; an earlier entry becomes void."""
        gap.turn += 1
        if dt != math.inf and not gap.joined:
            hi, lo = later(now, dt)
            heapq.heappush(self.calendar, (hi, lo, gap.index, gap.turn))

    def predict(self, gap: Gap, now: Time, own_separation: bool = False) -> None:
        """When does this gap close? The gap is up to date."""
        if gap.left.motion is None and gap.right.motion is None:
            self.schedule(gap, now, next_touch(gap, now, own_separation))
        else:
            found = touch_during_contact(gap, now)
            self.schedule(gap, now, math.inf if found is None else found)

    def around(self, gap: Gap, now: Time) -> None:
        """Bring the neighbouring gaps up to date before the bodies of `gap` change."""
        for other in self.chain.neighbours(gap):
            if other is not None and other.touching is None:
                self.chain.advance(other, now)

    def predict_around(self, gap: Gap, now: Time) -> None:
        """The bodies of `gap` have changed: their other neighbours may touch at another time."""
        for other in self.chain.neighbours(gap):
            if other is not None and other.touching is None:
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
        if gap.left.motion is not None or gap.right.motion is not None:
            self.join(gap, now)
            return
        self.around(gap, now)
        self.place(gap.left, now)
        self.place(gap.right, now)
        if gap.law is None:
            self.at_once(gap, now)
            self.predict_around(gap, now)
            return
        self.solvers["pair-contact"] += 1
        contact = resolve.touch(gap, now, self.record, self.ledger)
        self.schedule(gap, now, contact.duration)
        for other in self.chain.neighbours(gap):
            if other is not None and other.touching is None:
                # Velocities do not jump at a touch, but a neighbour in a contact has moved on.
                if other.left.motion is not None and other.right.motion is not None:
                    other.rate = velocity(other.right, now) - velocity(other.left, now)
                self.predict(other, now)

    def at_once(self, gap: Gap, now: Time) -> None:
        """A contact without duration between two bodies that are free, or settled."""
        self.solvers[gap.contact.law] += 1
        if gap.contact.law == "instant":
            resolve.instant(gap, now, self.record, self.ledger, self.fastest)
            self.predict(gap, now)
            return
        resolve.join(self.chain, gap, now, self.record, self.ledger)
        for other in self.chain.neighbours(gap):
            if other is not None and other.touching is None:
                self.chain.advance(other, now)

    def separate(self, gap: Gap, now: Time) -> None:
        """The force of a contact that is alone has become zero."""
        self.happened += 1
        self.around(gap, now)
        resolve.separate_pair(gap, now, self.record, self.ledger)
        self.predict(gap, now, own_separation=True)
        self.predict_around(gap, now)

    def join(self, gap: Gap, now: Time) -> None:
        """A touch while one of the two is in another contact: more than two bodies from now on."""
        touching = components.around(self.chain, gap)
        outer = self.outside([*touching, gap], now)
        components.settle(touching, now, self.record, self.ledger)
        for body in (gap.left, gap.right):
            self.place(body, now)
        gap.rate = gap.right.v - gap.left.v
        if gap.law is not None:
            resolve.touch_among_others(gap, now, self.record, self.ledger)
        else:
            self.at_once(gap, now)
            for other in touching:
                other.rate = other.right.v - other.left.v
        self.form_again([*touching, gap], outer, now)

    def step(self, gap: Gap, now: Time) -> None:
        """A cluster's step is over, or something happened in it."""
        assert gap.touching is not None and isinstance(gap.touching.solver, Cluster)
        cluster = gap.touching.solver
        touching = list(cluster.gaps)
        outer = self.outside(touching, now)
        components.settle(touching, now, self.record, self.ledger)
        for k, cause in cluster.ends:
            if touching[k].touching is None:
                continue  # it came apart at the very end of its branch
            components.leave_branch(touching[k], cause, now, self.record, self.ledger)
            self.happened += touching[k].touching is None
        self.form_again(touching, outer, now)

    def outside(self, touching: list[Gap], now: Time) -> list[Gap]:
        """The gaps around a component, brought to `now` before its bodies change."""
        found: list[Gap] = []
        for body in components.bodies_of(touching):
            for index in (body.left, body.right):
                other = self.chain.gaps[index]
                if other is not None and other.touching is None and other not in found:
                    self.chain.advance(other, now)
                    found.append(other)
        return found

    def form_again(self, gaps: list[Gap], outer: list[Gap], now: Time) -> None:
        """What still touches gets new solvers; everything around is predicted anew."""
        still = sorted((g for g in gaps if g.touching is not None), key=lambda g: g.index)
        for body in components.bodies_of([*gaps]):
            self.record.piece(body)
        for solver in components.form(still, now, self.record):
            first = solver.gaps[0] if isinstance(solver, Cluster) else self.chain.gaps[solver.gap]
            assert first is not None
            name = "pair-contact" if isinstance(solver, PairContact) else "coupled-contacts"
            self.solvers[name] += 1
            self.steps += 1
            self.schedule(first, now, solver.duration)
        for gap in still:
            mover = gap.touching.solver if gap.touching is not None else None
            if isinstance(mover, Cluster) and gap is not mover.gaps[0]:
                gap.turn += 1  # the cluster's events stand under its first gap
        for gap in gaps:
            if gap.touching is None and not gap.joined:
                self.predict(gap, now, own_separation=True)
        for other in outer:
            if other.touching is None and not other.joined and other not in gaps:
                other.rate = velocity(other.right, now) - velocity(other.left, now)
                self.predict(other, now)

    def result(self, end: Time, full: bool) -> Run:
        """Bring everything to the end."""
        scene, record, touching = self.scene, self.record, []
        for gap in self.chain.gaps:
            if gap is not None and gap.touching is not None:
                touching.append(gap)
        if touching:
            components.settle(touching, end, record, self.ledger)
            for gap in touching:
                resolve.tell_peak(gap, record)
                assert gap.law is not None
                stored = gap.law.stored(-gap.room, -gap.rate, gap.memory)
                self.ledger.stored_final += stored
        x, v = [0.0] * len(scene.carts), [0.0] * len(scene.carts)
        for body in self.chain.bodies:
            at = body.x + moved(body, body.time, end)
            for cart, offset in zip(body.carts, record.offsets(body), strict=True):
                x[cart], v[cart] = at + offset, body.v
        ledger.close(self.ledger, scene, v)
        record.end(end[0], v)
        return Run(
            scene=scene,
            t=end[0],
            x=tuple(x),
            v=tuple(v),
            outcome=outcome_of(scene, end[0], v, self.max_events if full else None),
            record=record,
            ledger=self.ledger,
            solvers=self.solvers,
        )
