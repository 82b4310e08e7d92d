"""The run: detect the next event, advance to it, resolve it, record it.

Tier 0, free flight, and tier 1, one contact at a time, both in closed form. The calendar holds
one prediction per gap; a prediction that an event has overtaken is void and skipped.
"""

from __future__ import annotations

import heapq
import math
from collections import Counter
from dataclasses import dataclass

from sim.dynamics import ledger, resolve
from sim.dynamics.chain import Body, Chain, Gap, moved, velocity
from sim.dynamics.clock import ZERO, Time, later
from sim.dynamics.detect import next_touch, touch_during_contact
from sim.dynamics.ledger import Ledger
from sim.dynamics.outcome import Outcome, UnsolvedError
from sim.dynamics.record import Record
from sim.scene.model import Scene

MOST_EVENTS = 1_000_000
"""A run stops after this many events unless told otherwise: some scenes have infinitely many."""

REST_SPEED = 1e-12
"""m/s. Slower than this at the end counts as "came to rest" in words; it changes no number."""


@dataclass(frozen=True, slots=True)
class Run:
    """A finished run: where everything is, what happened, and what it took."""

    scene: Scene
    t: float
    x: tuple[float, ...]  # m, per cart from left to right
    v: tuple[float, ...]  # m/s
    outcome: Outcome
    record: Record
    ledger: Ledger
    solvers: Counter[str]


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
        _refuse_what_is_not_solved(scene)
        self.scene, self.max_events, self.record = scene, max_events, record
        self.chain = Chain(scene)
        self.ledger = Ledger()
        self.solvers: Counter[str] = Counter()
        self.calendar: list[tuple[float, float, int, int, bool]] = []
        self.happened = 0
        record.pieces = [[] for _ in scene.carts]
        for body in self.chain.bodies:
            self.solvers["free-flight"] += 1
            record.piece(body)
        for gap in self.chain.gaps:
            if gap is None:
                continue
            if gap.room < 0.0 and gap.law is not None:
                self.ledger.stored_initial += gap.law.stored(-gap.room, -gap.rate, 0.0)
                self.begin(gap, ZERO)
            elif gap.touching is None:
                self.predict(gap, ZERO)

    def finish(self) -> Run:
        end: Time = (self.scene.until, 0.0)
        calendar, gaps = self.calendar, self.chain.gaps
        full = False
        while calendar and calendar[0][0] <= end[0]:
            hi, lo, index, turn, third = heapq.heappop(calendar)
            gap = gaps[index]
            if gap is None or gap.turn != turn:
                continue
            if self.happened >= self.max_events:
                full, end = True, (hi, lo)
                break
            now = (hi, lo)
            if third:
                self.third_body(gap, now)
            elif gap.touching is not None:
                self.separate(gap, now)
            else:
                self.chain.advance(gap, now)
                self.begin(gap, now)
        return self.result(end, full)

    def predict(self, gap: Gap, now: Time, own_separation: bool = False) -> None:
        """Put the gap's next event into the calendar. The gap is up to date."""
        gap.turn += 1
        if gap.left.contact is None and gap.right.contact is None:
            dt, third = next_touch(gap, now, own_separation), False
        else:
            found = touch_during_contact(gap, now)
            dt, third = (math.inf, False) if found is None else (found, True)
        if dt != math.inf:
            hi, lo = later(now, dt)
            heapq.heappush(self.calendar, (hi, lo, gap.index, gap.turn, third))

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
        if gap.left.contact is not None or gap.right.contact is not None:
            self.third_body(gap, now)
        self.around(gap, now)
        self.place(gap.left, now)
        self.place(gap.right, now)
        law = gap.contact.law
        if law == "instant":
            self.happened += 1
            self.solvers["instant"] += 1
            resolve.instant(gap, now, self.record, self.ledger)
        elif law == "velcro":
            self.happened += 1
            self.solvers["velcro"] += 1
            resolve.join(self.chain, gap, now, self.record, self.ledger)
            for other in self.chain.neighbours(gap):
                if other is not None:
                    self.chain.advance(other, now)
        else:
            self.happened += 2
            self.solvers["pair-contact"] += 1
            contact = resolve.touch(gap, now, self.record)
            hi, lo = later(now, contact.duration)
            gap.turn += 1
            if hi < math.inf:
                heapq.heappush(self.calendar, (hi, lo, gap.index, gap.turn, False))
            for other in self.chain.neighbours(gap):
                if other is not None and other.touching is None:
                    self.predict(other, now)  # velocities do not jump at a touch
            return
        if law == "instant":
            self.predict(gap, now)
        self.predict_around(gap, now)

    def separate(self, gap: Gap, now: Time) -> None:
        """The force of a contact has become zero."""
        self.happened += 1
        self.around(gap, now)
        resolve.separate(gap, now, self.record, self.ledger)
        self.predict(gap, now, own_separation=True)
        self.predict_around(gap, now)

    def third_body(self, gap: Gap, now: Time) -> None:
        """A touch while one of the two is still in another contact."""
        bodies: list[str] = []
        for body in (gap.left, gap.right):
            contact = body.contact
            if contact is not None:
                bodies.extend(self.scene.names_at(contact.gap))
        bodies.extend(self.scene.names_at(gap.index))
        order = ["left", *(cart.name for cart in self.scene.carts), "right"]
        names = tuple(name for name in order if name in bodies)
        raise UnsolvedError(
            f"At t = {now[0]:.6g} s {', '.join(names[:-1])} and {names[-1]} touch at once: "
            "this cannot be solved exactly yet",
            "move the carts apart, raise the stiffness, or use law: instant",
            now[0],
            names,
        )

    def result(self, end: Time, full: bool) -> Run:
        """Bring everything to the end."""
        scene = self.scene
        x, v = [0.0] * len(scene.carts), [0.0] * len(scene.carts)
        seen: set[int] = set()
        for body in self.chain.bodies:
            if not body.carts or id(body) in seen:
                continue
            seen.add(id(body))
            at, speed = body.x + moved(body, body.time, end), velocity(body, end)
            for cart, offset in zip(body.carts, self.record.offsets(body), strict=True):
                x[cart], v[cart] = at + offset, speed
        for gap in self.chain.gaps:
            if gap is not None and gap.touching is not None:
                resolve.unfinished(gap, end, self.record, self.ledger)
        ledger.close(self.ledger, scene, v)
        self.record.end(end[0], v)
        return Run(
            scene=scene,
            t=end[0],
            x=tuple(x),
            v=tuple(v),
            outcome=self.outcome(end[0], v, full),
            record=self.record,
            ledger=self.ledger,
            solvers=self.solvers,
        )

    def outcome(self, t: float, v: list[float], full: bool) -> Outcome:
        """Why it ended."""
        if full:
            return Outcome(
                "too-many-events",
                f"The run was stopped at t = {t:.6g} s after {self.max_events} events. "
                "Ask for an earlier end (until), more events (--max-events), or a larger "
                "restitution.",
            )
        if all(abs(speed) < REST_SPEED for speed in v):
            return Outcome("came-to-rest", f"Every cart is at rest at t = {t:.6g} s.")
        return Outcome("reached-end", f"The run reached its end at t = {t:.6g} s.")


def _refuse_what_is_not_solved(scene: Scene) -> None:
    if scene.effects:
        kinds = ", ".join(dict.fromkeys(effect.kind for effect in scene.effects))
        raise UnsolvedError(
            f"the effect {kinds} is not simulated yet", "remove it from effects", 0.0, ()
        )
    for k, contact in enumerate(scene.contacts):
        if contact is not None and contact.law == "hertz":
            raise UnsolvedError(
                "the contact law hertz is not simulated yet",
                "use law: bumper",
                0.0,
                scene.names_at(k),
            )
