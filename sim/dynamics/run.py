"""The run: detect the next event, advance to it, resolve it, record it.

Tier 0, flight, and tier 1, one contact at a time, are closed forms; tier 2, bodies that push each
other together, is a power series. The calendar holds one prediction per gap and per body; a
prediction that an event has overtaken is void and skipped.
"""

from __future__ import annotations

import heapq
import math
from collections import Counter
from collections.abc import Callable

from sim.dynamics import bursts, components, ending, ledger, resolve
from sim.dynamics.chain import Body, Chain, Gap, component, moved, velocity
from sim.dynamics.clock import ZERO, Time, elapsed, later
from sim.dynamics.cluster import Cluster
from sim.dynamics.contact import PairContact
from sim.dynamics.detect import next_touch, resting, touch_in_motion
from sim.dynamics.finished import Run, outcome_of
from sim.dynamics.form import form
from sim.dynamics.forces import Forces
from sim.dynamics.ledger import Ledger
from sim.dynamics.outcome import refuse_what_is_not_solved
from sim.dynamics.record import Record
from sim.scene.model import Scene

MOST_EVENTS = 1_000_000
"""A run stops after this many events unless told otherwise: some scenes have infinitely many."""

STEPS_PER_EVENT = 10
"""A contact of several carts takes a handful of steps; a run that needs ten times as many as it may
have events is one that never ends."""

MOST_STEPS = 300_000
"""Power series steps of one run, about a minute. Very stiff beside very soft takes more."""

Progress = Callable[[float, int], None]
"""Told now and then how far the run is: t [s] and the number of events so far."""

TELL_EVERY = 2048
"""Entries of the calendar between two words of progress."""


def run(
    scene: Scene,
    *,
    max_events: int = MOST_EVENTS,
    keep_events: bool = True,
    keep_motion: bool = True,
    progress: Progress | None = None,
) -> Run:
    """Run a scene exactly. Raises UnsolvedError where no exact solver is at hand."""
    return _Run(scene, max_events, Record(scene, keep_events, keep_motion)).finish(progress)


class _Run:
    """The state of one run in progress."""

    def __init__(self, scene: Scene, max_events: int, record: Record) -> None:
        refuse_what_is_not_solved(scene)
        self.scene, self.max_events, self.record = scene, max_events, record
        self.forces = Forces(scene) if scene.effects else None
        self.chain = Chain(scene, self.forces)
        self.ledger = Ledger()
        self.solvers: Counter[str] = Counter()
        self.calendar: list[tuple[float, float, int, int]] = []
        self.end: Time = (scene.until, 0.0)
        self.fastest = max(abs(cart.velocity) for cart in scene.carts)
        self.happened = 0
        self.steps = 0
        self.most_steps = min(STEPS_PER_EVENT * max_events, MOST_STEPS)
        record.pieces = [[] for _ in scene.carts]
        if self.forces is not None:
            self.begin_with_effects(self.forces)
            return
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

    def begin_with_effects(self, forces: Forces) -> None:
        """Latches, overlaps at the start, springs and magnets; then all solvers at once."""
        ledger.store(self.ledger, self.chain, first=True)
        for index, burst in enumerate(forces.bursts):
            bursts.latch(self.chain, burst, self.record)
            heapq.heappush(self.calendar, (burst.time, 0.0, self.outer(index), 0))
        for t in forces.switches:
            heapq.heappush(self.calendar, (t, 0.0, self.outer(len(forces.bursts)), 0))
        gaps = [gap for gap in self.chain.gaps if gap is not None]
        for gap in gaps:
            if gap.room < 0.0 and gap.law is not None and not gap.joined:
                resolve.touch(gap, ZERO, self.record, self.ledger)
        self.form_again(list(dict.fromkeys(self.chain.bodies)), gaps, ZERO)

    def outer(self, number: int) -> int:
        """Key in the calendar of what comes from outside: bursts, then all switches."""
        return len(self.scene.carts) + 1 + number

    def finish(self, progress: Progress | None = None) -> Run:
        end = self.end
        calendar, gaps, told = self.calendar, self.chain.gaps, 0
        full = False
        while calendar and calendar[0][0] <= end[0]:
            hi, lo, key, turn = heapq.heappop(calendar)
            now = (hi, lo)
            if key < 0:
                body = self.chain.bodies[-1 - key]
                if body.turn != turn:
                    continue
            elif key < len(gaps):
                gap = gaps[key]
                if gap is None or gap.turn != turn:
                    continue
            if self.happened >= self.max_events or self.steps >= self.most_steps:
                full, end = True, now
                break
            told += 1
            if progress is not None and told % TELL_EVERY == 0:
                progress(hi, self.happened)
            if key < 0:
                self.step(body, now)
            elif key >= len(gaps):
                self.from_outside(key - len(gaps), now)
            elif gap is not None:
                self.at_gap(gap, now)
        return self.result(end, full)

    def at_gap(self, gap: Gap, now: Time) -> None:
        """What was predicted for a gap happens."""
        if gap.solver is None:
            self.chain.advance(gap, now)
            self.begin(gap, now)
        elif isinstance(gap.solver, PairContact):
            self.separate(gap, now)
        else:
            self.step(gap.left if gap.left.carts else gap.right, now)

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
            self.schedule(gap, now, touch_in_motion(gap, now, self.end, own_separation))

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
        if self.forces is not None or not (gap.left.motion is None and gap.right.motion is None):
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
        self.schedule(gap, now, contact.duration)
        for other in self.chain.neighbours(gap):
            if other is not None and other.solver is None:
                # Velocities do not jump at a touch, but a neighbour in a contact has moved on.
                if other.left.motion is not None and other.right.motion is not None:
                    other.rate = velocity(other.right, now) - velocity(other.left, now)
                self.predict(other, now)

    def at_once(self, gap: Gap, now: Time, *, stays: bool) -> None:
        """A contact without duration between two bodies that are free, or settled."""
        self.solvers[gap.contact.law] += 1
        if gap.contact.law == "instant":
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
            isinstance(b.motion, (PairContact, Cluster)) for b in (gap.left, gap.right)
        )
        bodies, gaps = self.settle([gap.left, gap.right], now)
        if gap.left.mass < math.inf or gap.right.mass < math.inf:
            gap.rate = gap.right.v - gap.left.v
        self.fastest = max(self.fastest, -gap.rate)
        gaps = [*gaps, gap]
        if gap.law is not None:
            resolve.touch(gap, now, self.record, self.ledger)
        else:
            self.at_once(gap, now, stays=resolve.rests(gap, self.fastest, in_contact=in_contact))
            for other in gaps:
                if other is not gap and not other.joined:
                    other.rate = other.right.v - other.left.v
                    if other.law is None and other.rate != 0.0:
                        other.touching = None  # it rested; now it opens, or is struck in its turn
            bodies = [body for body in bodies if any(body is one for one in self.chain.bodies)]
        self.form_again(bodies, gaps, now)

    def settle(self, bodies: list[Body], now: Time) -> tuple[list[Body], list[Gap]]:
        """Settle the components of these bodies; the free gaps around them are brought to `now`.

        Returns all their bodies and member gaps, from left to right.
        """
        row: list[Body] = []
        gaps: list[Gap] = []
        for body in bodies:
            if body.carts and not any(body is other for other in row):
                more, between = component(self.chain, body)
                row += more
                gaps += between
        for body in row:
            for index in (body.left, body.right):
                other = self.chain.gaps[index]
                if other is not None and other.solver is None:
                    self.chain.advance(other, now)
        components.settle(row, gaps, now, self.record, self.ledger)
        return row, gaps

    def step(self, body: Body, now: Time) -> None:
        """A cluster's step or a flight is over, or something happened in it."""
        solver = body.motion
        bodies, gaps = self.settle([body], now)
        if isinstance(solver, Cluster):
            happened = ending.leave(solver, now, self.record, self.ledger)
            self.happened += happened
        else:
            body.v = 0.0
            ending.tell_stop(body, now, self.record)
            self.happened += 1
        self.form_again(bodies, gaps, now)

    def from_outside(self, number: int, now: Time) -> None:
        """A push begins or ends, or an exploder sets its energy free."""
        forces = self.forces
        assert forces is not None
        if number < len(forces.bursts):
            burst = forces.bursts[number]
            gap = self.chain.gaps[burst.gap]
            assert gap is not None
            bodies, gaps = self.settle([gap.left, gap.right], now)
            if gap.solver is None and not gap.joined:
                self.chain.advance(gap, now)
            changed = bursts.set_free(self.chain, gap, burst, now, self.record, self.ledger)
            self.happened += changed
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
        for solver in form(bodies, gaps, now, self.end, self.forces, self.record):
            self.solvers[solver.name] += 1
            if isinstance(solver, Cluster):
                self.steps += 1
            if not ready:
                continue
            if isinstance(solver, PairContact):
                first = self.chain.gaps[solver.gap]
            else:
                first = (
                    solver.members[0] if isinstance(solver, Cluster) and solver.members else None
                )
            if first is not None:
                self.schedule(first, now, solver.duration)
            else:
                self.schedule_body(
                    solver.bodies[0] if isinstance(solver, Cluster) else solver.body,
                    now,
                    solver.duration,
                )
        self.predict_all(bodies, gaps, now)

    def schedule_body(self, body: Body, now: Time, dt: float) -> None:
        """Put the end of a flight into the calendar; an earlier entry becomes void."""
        body.turn += 1
        if dt != math.inf:
            hi, lo = later(now, dt)
            heapq.heappush(self.calendar, (hi, lo, -1 - body.carts[0], body.turn))

    def predict_all(self, bodies: list[Body], gaps: list[Gap], now: Time) -> None:
        """Void what was predicted for members; predict every free gap of these bodies."""
        found: dict[int, Gap] = {}
        for body in bodies:
            if body.motion is None or isinstance(body.motion, PairContact):
                body.turn += 1
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

    def result(self, end: Time, full: bool) -> Run:
        """Bring everything to the end."""
        scene, record = self.scene, self.record
        bodies = list(dict.fromkeys(self.chain.bodies))
        touching = [gap for gap in self.chain.gaps if gap is not None and gap.solver is not None]
        components.settle(bodies, touching, end, record, self.ledger)
        for gap in touching:
            if gap.touching is not None and gap.law is not None:
                resolve.tell_peak(gap, record)
                stored = gap.law.stored(-gap.room, -gap.rate, gap.memory)
                self.ledger.stored_final += stored
        for gap in self.chain.gaps:
            if gap is not None and gap.links and gap.solver is None and not gap.joined:
                self.chain.advance(gap, end)
        ledger.store(self.ledger, self.chain, first=False)
        x, v = [0.0] * len(scene.carts), [0.0] * len(scene.carts)
        for body in bodies:
            for cart, offset in zip(body.carts, record.offsets(body), strict=True):
                x[cart], v[cart] = body.x + offset, body.v
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
            effects=self.forces.used if self.forces is not None else Counter(),
            forces=self.forces,
        )
