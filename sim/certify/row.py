"""The row of bodies and gaps at one moment, brought from one event to the next.

Gaps are settled before the bodies around them: room and rate at an instant follow from the motions
up to it, and what touches has room 0, exactly.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

from sim.certify.band import Seen, State, united_states
from sim.certify.bodies import Body, Gap
from sim.certify.coupled import CoupledPhase
from sim.certify.inputs import Inputs
from sim.certify.instants import Instant, instant
from sim.certify.numbers.balls import ZERO, between, is_zero, upper
from sim.certify.phases import ContactPhase
from sim.certify.touches import Touch
from sim.scene.model import Scene
from sim.scene.track import body_name


@dataclass(frozen=True, slots=True, eq=False)
class Next:
    """Something that will happen at `when` if nothing comes before."""

    when: Instant
    kind: str  # touch, clear, end (of a phase), halt, switch, burst
    bodies: tuple[Body, ...]
    gap: Gap | None = None
    cause: str = ""
    body: Body | None = None
    carts: tuple[int, ...] = ()  # of a switch: which body they are in is known only then


@dataclass(frozen=True, slots=True)
class Told:
    """An event as it will be listed."""

    when: Instant
    kind: str
    bodies: tuple[str, ...]


def both_called(scene: Scene, gap: int) -> tuple[str, str]:
    """The two of a gap, as sentences call them: A and the right wall."""
    one, other = (body_name(name, scene.track) for name in scene.names_at(gap))
    return one, other


class RowState:
    """Bodies and gaps of a scene at the last time of each, and what was told so far."""

    def __init__(self, inputs: Inputs) -> None:
        self.inputs, self.scene = inputs, inputs.scene
        self.names = [cart.name for cart in self.scene.carts]
        self.zero, self.until = instant(0.0), instant(self.scene.until)
        self.bodies = [
            Body([k], inputs.masses[k], inputs.velocities[k], self.zero, load=[inputs.loads[k]])
            for k in range(len(self.names))
        ]
        walls = (Body([], None), Body([], None))
        row = [walls[0], *self.bodies, walls[1]]
        self.gaps = [
            Gap(
                k,
                self.scene.names_at(k),
                row[k],
                row[k + 1],
                contact,
                inputs.gaps[k],
                ZERO,
                self.zero,
                springs=tuple(inputs.springs.get(k, ())),
                called=both_called(self.scene, k),
            )
            for k, contact in enumerate(self.scene.contacts)
            if contact is not None
        ]
        self.moved = [ZERO for _ in self.names]  # m, of each cart
        self.touches: dict[int, Touch] = {}
        self.phases: dict[int, tuple[ContactPhase | CoupledPhase, list[Next]]] = {}
        self.coupled: dict[int, CoupledPhase | ContactPhase] = {}  # by gap
        self.present = self.zero
        self.running = False  # what holds at the start is no event
        self.ahead: dict[int, list[Next]] = {}  # of each gap
        self.told: list[Told] = []
        self.doubt = ""  # about the order of two events that are independent
        self.happened = 0
        self.seen: Seen = {}
        self.glimpsed: dict[float, list[State]] = {}

    def look(self, t: float) -> None:
        """Keep where everything is at a time [s] that is no later than what comes next.

        Within an event's own time it has happened or not: both are kept.
        """
        known = [*self.glimpsed.pop(t, []), self._state(t)]
        self.seen[t] = united_states(known)

    def glimpse(self, t: float) -> None:
        """Keep where everything is at a time at which the next event may have happened or not."""
        self.glimpsed.setdefault(t, []).append(self._state(t))

    def _state(self, t: float) -> State:
        """By motions that began before t; of one that perhaps did not, from its beginning on."""
        now, places, speeds = instant(t), [], []
        for displacement, body in zip(self.moved, self.bodies, strict=True):
            then = now
            if not upper(body.begun.ball) <= Fraction(t):
                tau = upper(now.minus(body.begun))
                then = body.begun.after(between(Fraction(0), max(tau, Fraction(0))))
            places.append(displacement + body.displacement(body.begun, then))
            speeds.append(body.speed(then))
        return places, speeds

    def settle(self, bodies: Iterable[Body], now: Instant) -> None:
        """Bring bodies to `now`, and the gaps around them."""
        bodies = {body: None for body in bodies if body.carts}
        for gap in self.gaps:
            if gap.joined or not ({gap.left, gap.right} & {*bodies}):
                continue
            if gap.since is not now:
                if gap.alike:
                    gap.since = now
                    continue
                coupled = self.coupled.get(gap.index)
                room, rate = (
                    (gap.room_at(now), gap.rate_at(now))
                    if coupled is None
                    else coupled.between(gap, now)
                )
                gap.room, gap.rate, gap.since = room, rate, now
                gap.spent = False
        for body in bodies:
            if body.begun is not now:
                displacement, v = body.displacement(body.begun, now), body.speed(now)
                for k in body.carts:
                    self.moved[k] = self.moved[k] + displacement
                body.v, body.begun = v, now

    def fly(self, bodies: Iterable[Body], now: Instant) -> None:
        """New motions; rates of the gaps around follow."""
        for body in bodies:
            if body.carts and body.phase is None:
                body.fly(now)
        for gap in self.gaps:
            if not gap.joined and not gap.bound and {gap.left, gap.right} & {*bodies}:
                if gap.since is not now:
                    raise AssertionError("a gap was not settled")
                if not self._alike(gap, now):
                    gap.rate = gap.right.speed(now) - gap.left.speed(now)

    def _alike(self, gap: Gap, now: Instant) -> bool:
        """Do both go on from `now` with one velocity, the same number?"""
        both = (gap.left, gap.right)
        present = all(b.still or b.begun is now or is_zero(b.a) for b in both)
        if present and gap.left.v is gap.right.v and gap.simple:
            gap.rate = ZERO
            return True
        return False

    def forget(self, bodies: Iterable[Body]) -> None:
        """What was foreseen around these bodies no longer holds."""
        for gap in self.gaps:
            if {gap.left, gap.right} & {body for body in bodies if body.carts}:
                self.ahead.pop(gap.index, None)

    def tell(self, when: Instant, kind: str, bodies: tuple[str, ...]) -> None:
        """An event for the list."""
        self.told.append(Told(when, kind, bodies))

    def tell_carts(self, when: Instant, kind: str, body: Body) -> None:
        """An event of every cart of a body."""
        self.tell(when, kind, tuple(self.names[k] for k in body.carts))

    def untell_carts(self, when: Instant, kind: str, body: Body) -> bool:
        """Take back an event that more of the same instant has undone; was there one?"""
        told = Told(when, kind, tuple(self.names[k] for k in body.carts))
        if told not in self.told:
            return False
        self.told.remove(told)
        return True
