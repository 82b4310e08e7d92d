"""What motions have in common: how long they last, and where in a pair or a row a body stands."""

from __future__ import annotations

from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.clock import Time, elapsed


class Lasting:
    """It lasts for `duration` s."""

    __slots__ = ()
    begun: Time
    duration: float

    def time_left(self, now: Time) -> float:
        """s to its end; inf if it has none."""
        return self.duration - elapsed(self.begun, now)


class Pair(Lasting):
    """Of two bodies; each moves by its share of what the overlap does."""

    __slots__ = ()
    bodies: list[Body]
    mu: float

    def side(self, body: Body) -> float:
        """Signed share in the overlap: +mu/m for the left body, −mu/m for the right one."""
        return self.mu / body.mass if body is self.bodies[0] else -self.mu / body.mass


class Row(Lasting):
    """Of bodies beside each other."""

    __slots__ = ()
    bodies: list[Body]
    members: list[Gap]

    @property
    def gaps(self) -> tuple[int, ...]:
        """The gaps of the chain that it moves."""
        return tuple(gap.index for gap in self.members)

    def side(self, body: Body) -> float:
        """The body's place in the row."""
        return float(self.place(body))

    def place(self, body: Body) -> int:
        """The same, to count by."""
        for k, other in enumerate(self.bodies):
            if other is body:
                return k
        raise ValueError(body)
