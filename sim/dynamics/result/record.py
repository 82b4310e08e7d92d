"""What a run leaves behind: events, and the pieces of motion that a trajectory is made of."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field

from sim.dynamics.result.events import ORDER, Event
from sim.dynamics.state.body import Body, Gap, Motion
from sim.dynamics.state.clock import Time
from sim.dynamics.state.touching import Loose
from sim.scene.model import Scene

TOLD = 100
"""Parts kept for the plan where nothing else is kept."""


@dataclass(slots=True)
class Piece:
    """The motion of one cart from `start` until its next piece."""

    start: Time
    x: float  # m, at start
    v: float  # m/s, at start, or that of the common centre in a contact
    motion: Motion | None = None  # None: free flight
    side: float = 0.0  # which body of the motion this is
    sliding: int = 0  # direction in which friction sees it slide; 0: held, or no friction


@dataclass(slots=True)
class Solved:
    """One solver's part of the run, from `begin` to `end` s; `gaps` are those it moved."""

    solver: Motion
    gaps: tuple[int, ...]
    begin: float
    end: float


@dataclass(slots=True)
class Joint:
    """Two neighbours held together from `begin` to `end` s, `room` m between their edges."""

    gap: int
    begin: float
    room: float
    end: float = math.inf


@dataclass(slots=True)
class Record:
    """Collects what was asked for: `keep_events` and `keep_motion`; counts are always kept."""

    scene: Scene
    keep_events: bool
    keep_motion: bool
    events: list[Event] = field(default_factory=list)
    counts: defaultdict[str, int] = field(default_factory=lambda: defaultdict(int))
    pieces: list[list[Piece]] = field(default_factory=list)
    solved: list[Solved] = field(default_factory=list)
    solved_all: bool = True
    joints: list[Joint] = field(default_factory=list)
    rooms: dict[int, float] = field(default_factory=dict)
    """m. Per gap: the room of its first joint."""
    idle_bursts: list[tuple[int, float, float]] = field(default_factory=list)
    """Gap, time [s] and room [m] of exploders whose carts did not touch."""
    let_go: list[Loose] = field(default_factory=list)
    """Springs of exploders, whether they have fallen off or not."""
    deepest: dict[int, tuple[float, float]] = field(default_factory=dict)
    """Per gap: greatest overlap [m] and the approach speed [m/s] of that contact."""
    growing: dict[int, float] = field(default_factory=dict)
    """N. Per gap: the force of a contact that still grew when the run ended."""

    def piece(self, body: Body) -> None:
        """The body's motion changed at its time."""
        if not self.keep_motion:
            return
        side = 0.0 if body.motion is None else body.motion.side(body)
        if len(body.carts) == 1:
            piece = Piece(body.time, body.x, body.v, body.motion, side, body.sliding)
            self.pieces[body.carts[0]].append(piece)
            return
        for cart, offset in zip(body.carts, self.offsets(body), strict=True):
            self.pieces[cart].append(
                Piece(body.time, body.x + offset, body.v, body.motion, side, body.sliding)
            )

    def offsets(self, body: Body) -> list[float]:
        """m. How far each cart's centre is from the first one's: they touch, edge to edge."""
        at, before, offsets = 0.0, None, []
        for k in body.carts:
            cart = self.scene.carts[k]
            if before is not None:
                at += 0.5 * (before.length + cart.length) + self.rooms.get(k, 0.0)
            offsets.append(at)
            before = cart
        return offsets

    def join(self, gap: Gap, now: Time) -> None:
        """Two bodies stick together, edge to edge or with the overlap that a latch holds."""
        room = min(gap.room, 0.0) if gap.law else 0.0
        self.joints.append(Joint(gap.index, now[0], room))
        self.rooms.setdefault(gap.index, room)

    def part(self, gap: Gap, now: Time) -> None:
        """A latch opens."""
        for joint in self.joints:
            if joint.gap == gap.index and joint.end == math.inf:
                joint.end = now[0]

    def depth(self, gap: Gap, deepest: float) -> None:
        """Keep the deepest overlap of each gap, for the warning about short bumpers."""
        if deepest > self.deepest.get(gap.index, (0.0, 0.0))[0]:
            touching = gap.touching
            speed = 0.0 if touching is None else touching.before[0] - touching.before[1]
            self.deepest[gap.index] = (deepest, speed)

    def finished(self, solver: Motion, end: float) -> None:
        """A solver has done its part, at `end` s."""
        if self.keep_motion or len(self.solved) < TOLD:
            self.solved.append(Solved(solver, solver.gaps, solver.begun[0], end))
        else:
            self.solved_all = False

    def end(self, t: float, v: Sequence[float]) -> None:
        """The last event; then everything is put in order."""
        self.counts["end"] += 1
        if self.keep_events:
            speeds = {c.name: s for c, s in zip(self.scene.carts, v, strict=True)}
            self.events.append(Event(t, "end", tuple(speeds), speeds, speeds, 0.0, None))
            places = {name: k for k, name in enumerate(["left", *speeds, "right"])}
            self.events.sort(key=lambda e: (e.t, ORDER.index(e.kind), places[e.bodies[0]]))

    def forget_contact(self, gap: Gap) -> None:
        """The last contact of a gap, which was none."""
        self.counts["contact"] -= 1
        names = self.scene.names_at(gap.index)
        for k in range(len(self.events) - 1, -1, -1):
            if self.events[k].kind == "contact" and self.events[k].bodies == names:
                del self.events[k]
                return

    def moment(self, kind: str, body: Body, now: Time) -> None:
        """A body stops or starts: every cart of it, on its own."""
        self.counts[kind] += 1
        if self.keep_events:
            names = tuple(self.scene.carts[k].name for k in body.carts)
            speeds = dict.fromkeys(names, body.v)
            self.events.append(Event(now[0], kind, names, speeds, speeds, 0.0, None))

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
        names = left, right = self.scene.names_at(gap.index)
        earlier: dict[str, float] = {}
        later: dict[str, float] = {}
        if gap.left.carts:
            earlier[left], later[left] = before[0], after[0]
        if gap.right.carts:
            earlier[right], later[right] = before[1], after[1]
        self.events.append(Event(now[0], kind, names, earlier, later, impulse, force))
