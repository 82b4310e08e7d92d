"""What a run leaves behind: events, and the pieces of motion that a trajectory is made of."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field

from sim.dynamics.chain import Body, Gap
from sim.dynamics.clock import Time
from sim.dynamics.cluster import Cluster
from sim.dynamics.contact import PairContact
from sim.dynamics.events import ORDER, Event
from sim.scene.model import Scene


@dataclass(slots=True)
class Piece:
    """The motion of one cart from `start` until its next piece."""

    start: Time
    x: float  # m, at start
    v: float  # m/s, at start, or that of the common centre in a contact
    motion: PairContact | Cluster | None = None  # None: free flight
    side: float = 0.0  # which body of the motion this is


@dataclass(frozen=True, slots=True)
class Solved:
    """One solver's part of the run: `gaps` touch from `begin` to `end` s."""

    solver: PairContact | Cluster
    gaps: tuple[int, ...]
    begin: float
    end: float


@dataclass(slots=True)
class Record:
    """Collects what was asked for: `keep_events` and `keep_motion`; counts are always kept."""

    scene: Scene
    keep_events: bool
    keep_motion: bool
    events: list[Event] = field(default_factory=list)
    counts: Counter[str] = field(default_factory=Counter)
    pieces: list[list[Piece]] = field(default_factory=list)
    solved: list[Solved] = field(default_factory=list)
    joints: list[tuple[int, Time]] = field(default_factory=list)  # gap, when it stuck
    deepest: dict[int, tuple[float, float]] = field(default_factory=dict)
    """Per gap: greatest overlap [m] and the approach speed [m/s] of that contact."""

    def piece(self, body: Body) -> None:
        """The body's motion changed at its time."""
        if not self.keep_motion:
            return
        side = 0.0 if body.motion is None else body.motion.side(body)
        for cart, offset in zip(body.carts, self.offsets(body), strict=True):
            self.pieces[cart].append(Piece(body.time, body.x + offset, body.v, body.motion, side))

    def offsets(self, body: Body) -> list[float]:
        """m. How far each cart's centre is from the first one's: they touch, edge to edge."""
        at, before, offsets = 0.0, None, []
        for k in body.carts:
            cart = self.scene.carts[k]
            if before is not None:
                at += 0.5 * (before.length + cart.length)
            offsets.append(at)
            before = cart
        return offsets

    def join(self, gap: Gap, now: Time) -> None:
        """Two bodies stick together."""
        self.joints.append((gap.index, now))

    def depth(self, gap: Gap, deepest: float) -> None:
        """Keep the deepest overlap of each gap, for the warning about short bumpers."""
        if deepest > self.deepest.get(gap.index, (0.0, 0.0))[0]:
            touching = gap.touching
            speed = 0.0 if touching is None else touching.before[0] - touching.before[1]
            self.deepest[gap.index] = (deepest, speed)

    def finished(self, solver: PairContact | Cluster, gaps: tuple[int, ...], end: float) -> None:
        """A solver has done its part, at `end` s."""
        if self.keep_motion:
            self.solved.append(Solved(solver, gaps, solver.begun[0], end))

    def end(self, t: float, v: Sequence[float]) -> None:
        """The last event; then everything is put in order."""
        self.counts["end"] += 1
        if self.keep_events:
            speeds = {c.name: s for c, s in zip(self.scene.carts, v, strict=True)}
            self.events.append(Event(t, "end", tuple(speeds), speeds, speeds, 0.0, None))
            places = {name: k for k, name in enumerate(["left", *speeds, "right"])}
            self.events.sort(key=lambda e: (e.t, ORDER.index(e.kind), places[e.bodies[0]]))

    def event(
        self,
        kind: str,
        gap: Gap,
        now: Time,
        before: tuple[float, float],
        after: tuple[float, float],
        impulse: float,
        force: float | None,
    ) -> None:
        """Count an event and, where asked for, keep it."""
        self.counts[kind] += 1
        if not self.keep_events:
            return
        names = self.scene.names_at(gap.index)
        bodies = (gap.left, gap.right)
        self.events.append(
            Event(
                now[0],
                kind,
                names,
                {n: v for n, v, b in zip(names, before, bodies, strict=True) if b.carts},
                {n: v for n, v, b in zip(names, after, bodies, strict=True) if b.carts},
                impulse,
                force,
            )
        )
