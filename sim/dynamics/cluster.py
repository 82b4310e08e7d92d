"""Several contacts that share bodies, all at once: tier 2, stepped by power series.

A cluster is a run of neighbouring gaps that all touch. It lives for one step of the series, or
until something happens in it: a contact's force becomes zero, a bumper turns from one line of its
law to the other. Then it is taken apart and what still touches forms anew, as a cluster or, where
only one contact is left, as a closed form.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

from sim.dynamics.clock import Time, elapsed
from sim.dynamics.laws import Bumper, Paper, PushOnly
from sim.dynamics.series import (
    LOCKED,
    Branch,
    Poly,
    expand,
    first_fall,
    integral,
    size,
    slope,
    step_length,
    value,
)

Cause = Literal["apart", "turn", "climb"]
"""apart: the force is zero. turn: a bumper is deepest. climb: it is back at its old depth, or, with
e = 0, pressed as hard as at its greatest overlap."""

NEGLIGIBLE = 1e-13
"""Of the largest force in the cluster. Far ahead of the push that runs through a touching chain the
forces are a rounding error of it and less, and their sign means nothing: such a contact is kept."""

if TYPE_CHECKING:
    from sim.dynamics.chain import Body, Gap


def branch_of(gap: Gap) -> Branch:
    """The linear branch of its law that holds in a gap just after now."""
    law, d, v, memory = gap.law, -gap.room, -gap.rate, gap.memory
    assert law is not None and gap.touching is not None
    if isinstance(law, Bumper):
        if law.e == 1.0 or (d >= memory and (v > 0.0 or gap.touching.pressing)):
            return Branch(law.stiffness, 0.0, 0.0)
        if law.e == 0.0:
            return LOCKED
        return Branch(law.stiffness / law.e**2, 0.0, law.resting_overlap(max(memory, d)))
    assert isinstance(law, (Paper, PushOnly))
    return Branch(law.stiffness, law.damper(gap.mu), 0.0)


@dataclass(slots=True)
class Cluster:
    """One step of several touching gaps, from `begun`. `duration` is the step's length in s."""

    gaps: list[Gap]
    begun: Time
    over: list[Poly] = field(init=False)  # m, overlaps
    force_of: list[Poly] = field(init=False)  # N
    speed: list[Poly] = field(init=False)  # m/s, of bodies; walls stay
    path: list[Poly] = field(init=False)  # m, from where they were
    duration: float = field(init=False)
    ends: list[tuple[int, Cause]] = field(init=False, default_factory=list)

    def __post_init__(self) -> None:
        bodies = [self.gaps[0].left, *(gap.right for gap in self.gaps)]
        masses = [body.mass for body in bodies]
        overlaps = [-gap.room for gap in self.gaps]
        rates = [-gap.rate for gap in self.gaps]
        branches = [branch_of(gap) for gap in self.gaps]
        self.duration = step_length(masses, branches)
        self.over, self.force_of, pulls = expand(masses, overlaps, rates, branches)
        self.speed = [[body.v, *integral(a)[1:]] for body, a in zip(bodies, pulls, strict=True)]
        self.path = [integral(v) for v in self.speed]
        if all(branch.locked for branch in branches):  # nobody pushes them together any more
            self.ends = [(k, "apart") for k in range(len(branches))]
            self.duration = 0.0
            return
        sizes = [size(force, self.duration) for force in self.force_of]
        noise = NEGLIGIBLE * max(sizes)
        for k, (gap, branch) in enumerate(zip(self.gaps, branches, strict=True)):
            if sizes[k] < noise:
                continue
            for cause, watched in self._watch(k, gap, branch):
                found = first_fall(watched, self.duration)
                if found is not None:
                    self.ends = [e for e in self.ends if found == self.duration]
                    self.ends.append((k, cause))
                    self.duration = found

    def _watch(self, k: int, gap: Gap, branch: Branch) -> list[tuple[Cause, Poly]]:
        """What ends the branch of gap k when it falls to zero."""
        law, over = gap.law, self.over[k]
        if isinstance(law, Paper):
            return [("apart", over)]
        if not isinstance(law, Bumper) or law.e == 1.0:
            return [("apart", self.force_of[k])]
        if branch.locked:
            force = self.force_of[k]
            spare = [law.stiffness * over[0] - force[0], *(-c for c in force[1:])]
            return [("apart", force), ("climb", spare)]
        if branch.rest == 0.0:
            return [("apart", self.force_of[k]), ("turn", slope(over))]
        return [
            ("apart", self.force_of[k]),
            ("climb", [gap.memory - over[0], *(-c for c in over[1:])]),
        ]

    def state(self, place: float, tau: float) -> tuple[float, float, float]:
        """Displacement [m], v [m/s], a [m/s²] of the body at that place in the row."""
        k = int(place)
        return (
            value(self.path[k], tau),
            value(self.speed[k], tau),
            value(slope(self.speed[k]), tau),
        )

    def force(self, gap: int, tau: float) -> tuple[float, float]:
        """N and dN/dt of a gap of the chain."""
        k = next(k for k, own in enumerate(self.gaps) if own.index == gap)
        return value(self.force_of[k], tau), value(slope(self.force_of[k]), tau)

    def marks(self) -> list[float]:
        """One formula holds for the whole step."""
        return []

    def side(self, body: Body) -> float:
        """The body's place in the row."""
        return float(self.index(body))

    def index(self, body: Body) -> int:
        """Place of a body in the row."""
        if body is self.gaps[0].left:
            return 0
        return next(k + 1 for k, gap in enumerate(self.gaps) if gap.right is body)

    def shift(self, body: Body, start: Time, end: Time) -> float:
        """m. How far a body goes between two times within the step."""
        path = self.path[self.index(body)]
        a, b = elapsed(self.begun, start), elapsed(self.begun, end)
        return value(path, b) - (value(path, a) if a != 0.0 else 0.0)

    def velocity(self, body: Body, now: Time) -> float:
        """m/s."""
        return value(self.speed[self.index(body)], elapsed(self.begun, now))

    def excess(self, body: Body, start: Time, dt: float) -> float:
        """m. Displacement in dt s beyond that at the velocity of `start`."""
        path = self.path[self.index(body)]
        a = elapsed(self.begun, start)
        if a == 0.0:
            return value([0.0, 0.0, *path[2:]], dt)
        return value(path, a + dt) - value(path, a) - value(slope(path), a) * dt

    def speeds(self, body: Body) -> tuple[float, float]:
        """Least and greatest velocity in the step, bounded by the coefficients."""
        speed = self.speed[self.index(body)]
        reach, power = 0.0, 1.0
        for c in speed[1:]:
            power *= self.duration
            reach += abs(c) * power
        return speed[0] - reach, speed[0] + reach

    def acceleration(self, body: Body) -> float:
        """m/s². Bound over the step."""
        speed = self.speed[self.index(body)]
        total, power = 0.0, 1.0
        for n, c in enumerate(speed[1:], start=1):
            total += n * abs(c) * power
            power *= self.duration
        return total

    def time_left(self, now: Time) -> float:
        """s to the end of the step."""
        return self.duration - elapsed(self.begun, now)
