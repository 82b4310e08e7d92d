"""Bumpers that give nothing back, for the oracle: held at their greatest overlap by what presses.

    press   N = k d until d' = 0; then both move as one and N is whatever that takes:
    held    until N = 0: they part, and touch again at the overlap that is remembered;
            or until N = k d: pressed further

Dampers of their neighbours stay those of the bodies, and impulses go to the body that is hit: a
bumper has a duration. Where friction may carry a part of the load N is not known: no verdict.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from tests.reference.contact_branches import DEAD, UnsupportedError
from tests.reference.one_body import Group
from tests.reference.row_of_carts import NOTHING, Row

PARTS = 1e-9
"""m/s. Two that open faster when they turn were never pressed: they grazed."""


class HeldRow(Row):
    """A row in which some gaps are held."""

    held_at: frozenset[int] = frozenset()

    def body(self, cart: int) -> list[int]:
        """The carts that move with this one whatever happens: no held bumper lies between."""
        group = self.group(cart)
        carts = sorted(group.carts) if group else []
        first = last = cart
        while first - 1 in carts and first not in self.held_at:
            first -= 1
        while last + 1 in carts and last + 1 not in self.held_at:
            last += 1
        return list(range(first, last + 1)) if carts else []

    def inverse_mass(self, cart: int) -> float:
        carts = self.body(cart)
        stuck = self.joined - self.held_at
        if not carts or (0 in stuck and 0 in carts) or (self.n in stuck and self.n - 1 in carts):
            return 0.0
        return 1 / sum(self.m[i] for i in carts)

    def part(self, k: int, impulse: float) -> None:
        for sign, i in ((-1, k - 1), (1, k)):
            inverse = self.inverse_mass(i)
            for cart in self.body(i) if inverse else ():
                self.v[cart] += sign * impulse * inverse
        for held in sorted(self.held_at):
            s = self.overlap(held, self.x, self.v)[1]
            if abs(s) > NOTHING:
                self.let_go(held, "press" if s > 0 else "open")

    def join(self, k: int) -> None:
        for i in (k - 1, k):
            group = self.group(i)
            if k not in self.held_at and group and self._holds_a_gap(group.carts):
                raise UnsupportedError("velcro beside a held bumper")
        super().join(k)

    def _holds_a_gap(self, carts: list[int]) -> bool:
        """Is a gap beside one of these carts held, one at a wall too?"""
        return any(k in self.held_at for i in carts for k in (i, i + 1))

    def let_go(self, k: int, state: str) -> None:
        """The bodies of gap k move on their own."""
        branch = self.branches[k]
        assert branch is not None
        self.branches[k] = replace(branch, state=state)
        self.held_at -= {k}
        self.joined.discard(k)
        group = self.group(k - 1) or self.group(k)
        assert group is not None
        at = self.groups.index(group)
        sides = [[i for i in group.carts if i < k], [i for i in group.carts if i >= k]]
        self.groups[at : at + 1] = [Group(side, self._stands(side)) for side in sides if side]

    def _stands(self, carts: list[int]) -> bool:
        return (0 in self.joined and 0 in carts) or (self.n in self.joined and self.n - 1 in carts)

    def load(self, k: int, force: list[float]) -> float:
        """N. What holds gap k; `force` on each cart besides contacts that are held."""
        group = self.group(k - 1) or self.group(k)
        assert group is not None
        grips = sum(self.acting.grip[i][1] for i in group.carts)
        if grips and (group.held or group.fixed):
            raise UnsupportedError("friction and a held bumper share a load")
        total = {i: force[i] - group.sliding * self.acting.grip[i][0] for i in group.carts}
        mass = sum(self.m[i] for i in group.carts)
        a = 0.0 if group.fixed else sum(total.values()) / mass
        if not (0 in self.joined and 0 in group.carts):
            return sum(total[i] - self.m[i] * a for i in group.carts if i < k)
        if not (self.n in self.joined and self.n - 1 in group.carts):
            return sum(self.m[i] * a - total[i] for i in group.carts if i >= k)
        raise UnsupportedError("a row that is held between two walls")

    def watches(self, y: Any) -> list[tuple[float, Any]]:
        found = super().watches(y)
        if not self.held_at:
            return found
        x, v = y[: self.n], y[self.n : 2 * self.n]
        force = self.forces(x, v)[0]
        for k in sorted(self.held_at):
            branch = self.branches[k]
            assert branch is not None
            load = self.load(k, force)
            found += [(load, ("part", k)), (branch.k * branch.memory - load, ("climb", k))]
        return found

    def change(self, what: tuple[str, int]) -> None:
        state, k = what
        branch = self.branches.get(k) if state not in ("halt", "slip") else None
        if branch is None or branch.law != "bumper" or branch.e > DEAD:
            super().change(what)
            return
        d, s = self.overlap(k, self.x, self.v)
        if state == "turn" and s < -PARTS:
            self.branches[k] = replace(branch, state="open", memory=d)
        elif state == "turn":
            self.branches[k] = replace(branch, state="held", memory=d)
            self.held_at |= {k}
            super().join(k)
        elif state in ("part", "climb"):
            self.let_go(k, "open" if state == "part" else "press")
        elif state == "spring":  # pressed again where it was left
            self.branches[k] = replace(branch, state="press")
        else:
            self.branches[k] = branch.after(state, d)
        self.changes += 1
        self.judge()
