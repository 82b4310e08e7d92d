"""Bodies in a row, the gaps between them, and what every motion of them has to answer.

    gap 0   body 0   gap 1   body 1   ...   body n−1   gap n      a wall is a body of infinite mass

Gaps and closing speeds are the state; positions are carried along for show. A gap of carts at
x = 1e9 m is as exact as one at the origin. Each body and each gap has its own last time: an event
touches only its neighbourhood, so its cost does not grow with the number of bodies in the row.
"""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Protocol

from sim.dynamics.state.clock import NEVER, UNSEEN, ZERO, Time
from sim.dynamics.state.loads import NO_LOAD, Load
from sim.dynamics.state.touching import Loose, Touching
from sim.effects.forces import BodyForce, PairForce
from sim.laws.branch import Cause
from sim.laws.contact_law import ContactLaw, IsolatedContact, reduced_mass
from sim.laws.damped_oscillation import Rate
from sim.scene.model import Contact


@dataclass(frozen=True, slots=True)
class End:
    """What ended a motion, in which of its gaps (or, of halt and slip, to which of its bodies).

    `direction`: 1 to the right, −1 to the left, of a slip.
    """

    cause: Cause
    k: int
    direction: int = 0


PeakSoFar = tuple[float, float, float, tuple[float, float]]
"""s since the beginning, N, N s until then, m/s of the left and right body then."""


@dataclass(slots=True)
class GapRecord:
    """What a motion did in one gap. `over` and `rate` are the gap's, all else is its contact's."""

    over: float  # m
    rate: float  # m/s
    impulse: float = 0.0  # N s
    dissipated: float = 0.0  # J that it does not give back
    deepest: float = 0.0  # m, greatest overlap
    peaks: tuple[PeakSoFar, ...] = ()  # its greatest force is one of these
    summed: float = 0.0  # m s, integral of the overlap; asked for by loose springs alone


class Accounts(Protocol):
    """Where a motion books what it did to bodies."""

    def push_from_outside(self, impulse: float, by: str = "walls") -> None:
        """`by` gave the carts `impulse` [N s], + to the right."""

    def work(self, by: str, energy: float) -> None:
        """An effect gave the carts `energy` [J]."""


class Motion(Protocol):
    """A motion of one body or several until something ends it. Times t and tau in s since `begun`.

    `tier`: 0 flight, 1 one pair, 2 several bodies at once, 3 integrated. `members` are the gaps
    that it moves too, `gaps` their numbers; those of its bodies that touch have contacts.
    """

    @property
    def name(self) -> str:
        """Of its solver, in plans and counts."""

    @property
    def tier(self) -> int:
        """How dear its solver is."""

    @property
    def begun(self) -> Time:
        """When it began."""

    @property
    def duration(self) -> float:
        """s. How long it lasts; inf: until somebody else ends it."""

    @property
    def bodies(self) -> list[Body]:
        """Those that it moves, and walls they touch, from left to right."""

    @property
    def members(self) -> list[Gap]:
        """The gaps between them that it moves."""

    @property
    def ends(self) -> list[End]:
        """What ends it."""

    @property
    def gaps(self) -> tuple[int, ...]:
        """Numbers of the gaps that it moves, from left to right."""

    @property
    def parabolic(self) -> bool:
        """Is it a parabola, so that two samples draw it?"""

    @property
    def short_steps(self) -> bool:
        """Are its steps so short that few samples draw each?"""

    @property
    def fading(self) -> tuple[Rate, ...]:
        """Rates of the damped oscillations of which it is made, if it is."""

    def marks(self, end: float) -> list[float]:
        """Times up to `end` at which its curve changes, for drawing."""

    def time_left(self, now: Time) -> float:
        """s to its end; inf if it has none."""

    def side(self, body: Body) -> float:
        """Which of its bodies that is: the first argument of `state`."""

    def state(self, side: float, tau: float) -> tuple[float, float, float]:
        """Displacement [m], v [m/s], a [m/s²] of one of its bodies."""

    def shift(self, body: Body, start: Time, end: Time) -> float:
        """m. How far a body goes between two times."""

    def velocity(self, body: Body, now: Time) -> float:
        """m/s."""

    def excess(self, body: Body, start: Time, dt: float) -> float:
        """m. Displacement in dt s beyond that at the velocity of `start`."""

    def speeds(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """m/s. Bounds on the velocity from `now` on."""

    def accelerations(self, body: Body, now: Time, horizon: float) -> tuple[float, float]:
        """m/s². Bounds on the acceleration from `now` on."""

    def force(self, gap: int, tau: float) -> tuple[float, float]:
        """N and dN/dt in a gap: all that pushes the two apart."""

    def book(self, accounts: Accounts, t: float) -> None:
        """Impulses from outside and work up to t, by name."""

    def locked(self, k: int) -> bool:
        """Does the contact in its k-th gap keep its overlap?"""

    def parts(self, t: float, *, peaks: bool) -> list[GapRecord]:
        """What it did in each of its gaps up to t; `peaks`: their greatest forces are asked for."""


@dataclass(frozen=True, slots=True)
class Still:
    """What acts on a body that nothing moves, and who holds it: see `loop.still`."""

    since: Time
    forces: tuple[BodyForce, ...]
    by: str  # name in the account of momentum; empty: the forces balance each other


@dataclass(slots=True, eq=False)
class Body:
    """One cart, several that are stuck together, or a wall. `x` is its state at time `time`."""

    carts: tuple[int, ...]  # indices in the scene; empty: a wall
    mass: float  # kg
    x: float  # m, of the first cart's centre
    v: float  # m/s
    left: int  # gap on its left
    right: int  # gap on its right
    time: Time = ZERO
    motion: Motion | None = None  # None: free flight
    load: Load = NO_LOAD  # effects that act on it
    sliding: int = 0  # direction in which friction sees it slide
    held: bool = False  # by static friction
    slips: int = 0  # direction in which it has just overcome static friction
    changed: Time = NEVER  # when it last began or ceased to slide
    flips: int = 0  # how often at that instant (`flips`)
    alternates: int = 0  # how many of them count for the margin
    alternates_before: int = 0  # the same with the first change at this instant counted
    turn: int = 0  # counts predictions, as those of gaps
    still: Still | None = None  # at rest under forces


@dataclass(slots=True, eq=False)
class Gap:
    """The room between two neighbours, edge to edge; negative: their bumpers overlap."""

    index: int
    left: Body
    right: Body
    room: float  # m, at `time`
    rate: float  # m/s, right velocity minus left
    contact: Contact
    law: ContactLaw | None
    time: Time = ZERO
    due: Time = UNSEEN  # when its next event is foreseen
    memory: float = 0.0  # m, of the bumper
    spent: bool = False  # a release parted its overlap: it pushes when pressed again
    turn: int = 0  # counts predictions: an older one in the calendar is void
    touching: Touching | None = None
    links: tuple[PairForce, ...] = ()  # springs and magnets across it
    loose: tuple[Loose, ...] = ()  # those of them that fall off
    solver: Motion | None = None  # what moves it, while it touches or is linked
    joined: bool = False
    stride: float = 0.0  # s, of the next step that an adaptive method would take; 0: not known
    plain: int = 0  # steps in a row at whose end nothing happened
    formed: int = 0  # how often it has been in a row that is stepped
    changed: Time = NEVER  # when its mode changed last
    flips: int = 0  # how often at that instant (`flips`)
    alternates: int = 0  # how many of them count for the margin
    alternates_before: int = 0  # the same with the first change at this instant counted
    clear_at: Time | None = None  # when its overlap will have cleared, if that is known
    _figures: tuple[float, IsolatedContact] | None = field(default=None)

    @property
    def member(self) -> bool:
        """Do its two bodies push or pull each other?"""
        return self.touching is not None or (bool(self.links) and not self.joined)

    @property
    def mu(self) -> float:
        """Reduced mass in kg."""
        return reduced_mass(self.left.mass, self.right.mass)

    def figures(self, mu: float) -> IsolatedContact:
        """Those of the gap's law, computed once per reduced mass."""
        if self._figures is None or self._figures[0] != mu:
            assert self.law is not None
            self._figures = (mu, figures_of(self.law, mu))  # type: ignore[arg-type]
        return self._figures[1]


def kinds_of(gap: Gap) -> tuple[str, ...]:
    """What acts across it just now, besides a contact."""
    return tuple(link.kind for link in gap.links)


@lru_cache(maxsize=4096)
def figures_of(law: Hashable, mu: float) -> IsolatedContact:
    """The same pair meets again and again, in this run and in the next."""
    return law.figures(mu)  # type: ignore[attr-defined, no-any-return]
