"""The state of a row of carts, every force on it, and what changes which force acts.

Everything is written down once more from its definition, to be integrated by `effects.py`. Nothing
of `sim.dynamics` is used.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

from sim.scene import Scene
from tests.reference.contact_branches import DEAD, Branch, UnsupportedError, begin
from tests.reference.effects_acting import Acting
from tests.reference.one_body import Group

NOTHING = 1e-13
"""m or m/s. What rounding makes of nought: no sign."""


class Row:
    """The state of one integration."""

    errors: tuple[float, float]

    def __init__(self, scene: Scene) -> None:
        self.scene, n = scene, len(scene.carts)
        self.n, self.t = n, 0.0
        self.m = [cart.mass for cart in scene.carts]
        self.x = [cart.position for cart in scene.carts]
        self.v = [cart.velocity for cart in scene.carts]
        self.half = [0.5 * cart.length for cart in scene.carts]
        self.gaps = [k for k, contact in enumerate(scene.contacts) if contact is not None]
        self.groups = [Group([i]) for i in range(n)]
        self.joined: set[int] = set()
        self.branches: dict[int, Branch | None] = {}
        for k in self.gaps:
            contact = scene.contacts[k]
            d, s = self.overlap(k, self.x, self.v)
            if abs(d) < 1e-15:
                d = 0.0
            law, e = contact.law, contact.restitution
            if law == "bumper" and e < 0.02 and (e > DEAD or d > 0):
                raise UnsupportedError("rigid spring back")
            if d > 0 and law in ("instant", "velcro"):
                raise UnsupportedError("no law for what begins with an overlap")
            finite = law not in ("instant", "velcro")
            self.branches[k] = (
                begin(law, contact.stiffness, e, self.mu(k), d, s) if finite else None
            )
        self.acting = Acting(scene, self.gaps)
        self.kinds = self.acting.kinds
        self.work = [0.0] * len(self.kinds)
        self.changes = 0
        for _, k, effect in self.acting.releases:
            if "stiffness" in effect.numbers:
                raise UnsupportedError("a spring that falls off")
            d, s = self.overlap(k, self.x, self.v)
            if d > NOTHING:
                raise UnsupportedError("a release of an overlap")
            if abs(d) <= NOTHING and s == 0.0 and k not in self.joined:
                self.join(k)

    def group(self, cart: int) -> Group | None:
        return next((g for g in self.groups if cart in g.carts), None)

    def body(self, cart: int) -> list[int]:
        """The carts that move with this one; none with a wall."""
        group = self.group(cart)
        return group.carts if group else []

    def inverse_mass(self, cart: int) -> float:
        """1/kg, of the group of a cart; nought for walls and what sticks to them."""
        group = self.group(cart)
        return 0.0 if group is None or group.fixed else 1 / sum(self.m[i] for i in group.carts)

    def mu(self, k: int) -> float:
        inverse = self.inverse_mass(k - 1) + self.inverse_mass(k)
        return 1 / inverse if inverse else 1.0

    def regrouped(self) -> None:
        """Dampers are those of the bodies that now meet."""
        for k, branch in self.branches.items():
            if branch is not None and k not in self.joined:
                self.branches[k] = branch.between(self.mu(k))

    def overlap(self, k: int, x: Any, v: Any) -> tuple[float, float]:
        """Overlap and its rate in gap k."""
        if k == 0:
            return self.half[0] - x[0], -v[0]
        if k == self.n:
            return x[-1] + self.half[-1] - self.scene.track.length, v[-1]
        return x[k - 1] + self.half[k - 1] + self.half[k] - x[k], v[k - 1] - v[k]

    def join(self, k: int) -> None:
        """The bodies of gap k become one group."""
        self.joined.add(k)
        left, right = self.group(k - 1), self.group(k)
        one = left or right
        assert one is not None
        if left and right:
            mass = [sum(self.m[i] for i in g.carts) for g in (left, right)]
            fixed = left.fixed or right.fixed
            v = self.v[left.carts[0]] * mass[0] + self.v[right.carts[0]] * mass[1]
            v = 0.0 if fixed else v / sum(mass)
            self.groups.remove(right)
            left.carts += right.carts
            left.fixed = fixed
        else:
            one.fixed, v = True, 0.0
        for i in one.carts:
            self.v[i] = v
        self.regrouped()

    def forces(self, x: Any, v: Any) -> tuple[list[float], list[float]]:
        """Force on each cart without friction, and the power of each kind of effect."""
        force = [0.0] * self.n
        power = dict.fromkeys(self.kinds, 0.0)
        for k, branch in self.branches.items():
            if branch is not None and branch.state not in ("open", "idle") and k not in self.joined:
                self.push(force, k, branch.force(*self.overlap(k, x, v)))
        for k, e in self.acting.links:
            self.push(force, k, self.acting.link(e, *self.overlap(k, x, v), power))
        for i in range(self.n):
            force[i] += self.acting.alone(i, v[i], self.t, power)
        return force, [power[kind] for kind in self.kinds]

    def push(self, force: list[float], k: int, push: float) -> None:
        if k > 0:
            force[k - 1] -= push
        if k < self.n:
            force[k] += push

    def grips(self, group: Group) -> tuple[float, float]:
        both = [self.acting.grip[i] for i in group.carts]
        return sum(kinetic for kinetic, _ in both), sum(static for _, static in both)

    def judge(self) -> None:
        """Who is held, and who slides where."""
        force, _ = self.forces(self.x, self.v)
        for group in self.groups:
            static = self.grips(group)[1]
            total = sum(force[i] for i in group.carts)
            v = self.v[group.carts[0]]
            if group.fixed or static == 0.0:
                group.held, group.sliding = group.fixed, 0
            elif v == 0.0:
                group.held = abs(total) <= static
                group.sliding = 0 if group.held else int(math.copysign(1, total))
            else:
                group.held, group.sliding = False, int(math.copysign(1, v))

    def slope(self, y: Any) -> list[float]:
        plain = y.tolist()  # the same numbers: Python reckons with its own ones faster
        x, v = plain[: self.n], plain[self.n : 2 * self.n]
        force, power = self.forces(x, v)
        speed, a = [0.0] * self.n, [0.0] * self.n
        rub = 0.0
        for group in self.groups:
            if group.held or group.fixed:
                continue
            grip = -group.sliding * self.grips(group)[0]
            total = sum(force[i] for i in group.carts) + grip
            mass = sum(self.m[i] for i in group.carts)
            rub += grip * v[group.carts[0]]
            for i in group.carts:
                speed[i], a[i] = v[i], total / mass
        if "friction" in self.kinds:
            power[self.kinds.index("friction")] = rub
        return [*speed, *a, *power]

    def watches(self, y: Any) -> list[tuple[float, Any]]:
        """Values that are not negative while the present formulas hold."""
        plain = y.tolist()  # the same numbers: Python reckons with its own ones faster
        x, v = plain[: self.n], plain[self.n : 2 * self.n]
        found: list[tuple[float, Any]] = []
        for k, branch in self.branches.items():
            if k in self.joined:
                continue
            d, s = self.overlap(k, x, v)
            if branch is None:
                found.append((-d, ("hit", k)))
            else:
                found += [(value, (state, k)) for value, state in branch.watches(d, s)]
        force = None
        for number, group in enumerate(self.groups):
            if group.sliding:
                found.append((group.sliding * v[group.carts[0]], ("halt", number)))
            elif group.held and not group.fixed:
                force = force or self.forces(x, v)[0]
                total = sum(force[i] for i in group.carts)
                static = self.grips(group)[1]
                found.append(((static - abs(total)) / (static + 1e-300), ("slip", number)))
        return found

    def change(self, what: tuple[str, int]) -> None:
        """One formula gives way to the next."""
        state, k = what
        self.changes += 1
        if state == "halt":
            for i in self.groups[k].carts:
                self.v[i] = 0.0
        elif state not in ("slip", "hit"):  # impacts: `one_instant`
            branch = self.branches[k]
            assert branch is not None
            self.branches[k] = branch.after(state, self.overlap(k, self.x, self.v)[0])
        self.judge()

    def hit(self, k: int) -> None:
        """An impact without duration."""
        contact, s = self.scene.contacts[k], self.overlap(k, self.x, self.v)[1]
        if contact.law == "velcro":
            self.join(k)
            return
        self.part(k, (1 + contact.restitution) * s * self.mu(k))

    def part(self, k: int, impulse: float) -> None:
        """An impulse [N s] on both sides of gap k, outwards."""
        for sign, i in ((-1, k - 1), (1, k)):
            inverse = self.inverse_mass(i)
            for cart in self.body(i):
                self.v[cart] += sign * impulse * inverse

    def release(self, k: int, energy: float) -> None:
        d, s = self.overlap(k, self.x, self.v)
        branch = self.branches[k]
        if k in self.joined:
            group = self.group(k)
            assert group is not None
            left = [i for i in group.carts if i < k]
            right = [i for i in group.carts if i >= k]
            at = self.groups.index(group)
            self.groups[at : at + 1] = [Group(left), Group(right)]
            self.joined.discard(k)
            self.regrouped()
            if group.fixed:
                raise UnsupportedError("a latch at a wall")
        elif branch is not None and branch.state != "open":
            self.branches[k] = replace(branch, state="spent")
        elif d < -1e-12:
            return
        mu = self.mu(k)
        self.part(k, mu * (math.sqrt(s * s + 2 * energy / mu) + s))
