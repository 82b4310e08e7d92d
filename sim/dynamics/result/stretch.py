"""What holds between two marks of a run: which formulas move each cart, and who acts on whom."""

from __future__ import annotations

import math
from dataclasses import dataclass

from sim.dynamics.result import body_forces
from sim.dynamics.result.finished import Run
from sim.dynamics.result.record import Piece, Solved

State = tuple[float, float, float]
"""x [m], v [m/s], a [m/s²]."""


@dataclass(frozen=True, slots=True)
class Stretch:
    """Formulas that hold from one mark to the next; forces told by `gaps` and by name."""

    run: Run
    motion: list[Piece]
    live: list[Solved]
    gaps: list[int]
    stuck: set[int]
    named: list[tuple[str, str]]
    outside: body_forces.Outside

    def row(self, t: float) -> list[float]:
        """All columns at t."""
        states = [state(piece, t) for piece in self.motion]
        row = [t]
        for one in states:
            row += one
        forces = dict.fromkeys(self.gaps, (0.0, 0.0))
        for part in self.live:
            tau = (t - part.begin) - part.solver.begun[1]
            for gap in part.gaps:
                forces[gap] = part.solver.force(gap, tau)
        outer: dict[tuple[str, str], float] = {}
        if self.named:
            between = {gap: one for gap, (one, _) in forces.items() if gap not in self.stuck}
            outer = body_forces.at(self.outside, states, self.motion, between, self.stuck)
        if self.stuck:
            sums: dict[str, float] = {}
            for (_, name), force in outer.items():
                sums[name] = sums.get(name, 0) + force
            self._join(states, sums, forces)
        for gap in self.gaps:
            row += forces[gap]
        return row + [outer.get(name, 0.0) for name in self.named]

    def _join(
        self, states: list[State], outer: dict[str, float], forces: dict[int, tuple[float, float]]
    ) -> None:
        """Forces between carts that stick together, from what m a leaves over for its neighbours,
        F_left − F_right of each cart, and their slopes [N/s].

        Summed from the left end of a group; a group that holds on to the left wall from its right
        end.
        """
        carts, stuck = self.run.scene.carts, self.stuck
        slopes = self._slopes(states, {k: dF for k, (_, dF) in forces.items() if k not in stuck})
        needs = [
            (cart.mass * a - outer.get(cart.name, 0), slope)
            for cart, (_, _, a), slope in zip(carts, states, slopes, strict=True)
        ]
        wall = 0
        while wall < len(carts) and wall in stuck:
            wall += 1
        for gap in reversed(range(wall)):
            (force, slope), (more, steeper) = forces.get(gap + 1, (0.0, 0.0)), needs[gap]
            forces[gap] = force + more, slope + steeper
        for gap in sorted(gap for gap in stuck if gap >= wall):
            (force, slope), (more, steeper) = forces.get(gap - 1, (0.0, 0.0)), needs[gap - 1]
            forces[gap] = force - more, slope - steeper

    def _slopes(self, states: list[State], outer: dict[int, float]) -> list[float]:
        """N/s. How fast F_left − F_right of each cart grows; `outer`, forces at groups' ends.

        A group in motion shares it by mass, but for what drag takes; friction at rest bears it as
        it bears the force; a wall all.
        """
        carts, outside, found = self.run.scene.carts, self.outside, [0.0] * len(states)
        for body in body_forces.bodies(len(states), self.stuck):
            if body[0] in self.stuck or body[-1] + 1 in self.stuck:
                continue
            grows = outer.get(body[0], 0.0) - outer.get(body[-1] + 1, 0.0)
            limits = outside.limits(body)
            if limits and not self.motion[body[0]].sliding:
                for k in body:
                    found[k] = outside.limits(range(k, k + 1)) / limits * grows
                continue
            drags = [-outside.slope(k, *states[k][1:]) for k in body]
            jerk = (grows - math.fsum(drags)) / math.fsum(carts[k].mass for k in body)
            for k, drag in zip(body, drags, strict=True):
                found[k] = carts[k].mass * jerk + drag
        return found


def state(piece: Piece, t: float) -> State:
    """Of a cart whose piece holds at t."""
    tau = (t - piece.start[0]) - piece.start[1]
    if piece.motion is None:
        return piece.x + piece.v * tau, piece.v, 0.0
    shift, v, a = piece.motion.state(piece.side, tau)
    return piece.x + shift, v, a
