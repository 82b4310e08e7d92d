"""Forces of contacts, springs and magnets as series in a row's own time (`own_time`).

Each gives its n-th coefficient from those of overlap and rate up to n: the rate is a series beside
the overlap here, for it is not the overlap's slope in s. Of spheres N = K z^6 + C z d' with
z = d^(1/4), where the overlap of the contact that keeps the clock is z⁴, and another's powers are

    q = d^p :    n d_0 q_n = sum over j of (p j − (n − j)) d_j q_(n−j)          (Euler)
"""

from __future__ import annotations

import sys
from operator import mul

from sim.dynamics.motion.power_series.polynomial import Poly
from sim.effects.forces import PairForce, at_touch
from sim.laws.branch import Branch

if sys.version_info >= (3, 12):
    from math import sumprod as dot  # a coefficient of a product, from one series and one reversed
else:

    def dot(p: Poly, q: Poly) -> float:
        """A coefficient of a product, from one series and one reversed."""
        return float(sum(map(mul, p, q)))


class Clock:
    """dt/ds = w = unit z³ of the contact that keeps the clock; 1 where none does.

    The unit makes s a number like 1 in a step: z may be 1e-12, its cube's tenth power is no float.
    """

    def __init__(self, z: float | None, unit: float) -> None:
        self.unit = unit
        self.z: Poly = [] if z is None else [z]
        self.square: Poly = []
        self.cube: Poly = []
        self.w: Poly = []

    def move(self, n: int) -> None:
        """The n-th coefficient of w, once that of z is known."""
        if not self.z:
            self.w.append(0.0 if n else 1.0)
            return
        back = self.z[::-1]
        self.square.append(dot(self.z, back))
        self.cube.append(dot(self.square, back))
        self.w.append(self.unit * self.cube[n])


class LinearContact:
    """One linear branch, or nothing."""

    def __init__(self, branch: Branch) -> None:
        self.branch = branch
        self.damping: Poly = []

    def coefficient(self, n: int, o: Poly, r: Poly) -> float:
        """N."""
        push = self.branch.kappa * (o[n] if n else o[0] - self.branch.rest)
        return push + self.branch.gamma * r[n]


class ClockContact:
    """Spheres that keep the clock. `damping`: C z d' [N]."""

    def __init__(self, stiff: float, damper: float, clock: Clock) -> None:
        self.stiff, self.damper, self.clock = stiff, damper, clock
        self.damping: Poly = []

    def coefficient(self, n: int, o: Poly, r: Poly) -> float:
        """K z^6 + C z d'."""
        cube = self.clock.cube
        push = self.stiff * dot(cube, cube[::-1])
        if self.damper:
            self.damping.append(self.damper * dot(self.clock.z, r[::-1]))
            push += self.damping[n]
        return push


class PressedContact:
    """Spheres that are pressed already."""

    def __init__(self, stiff: float, damper: float) -> None:
        self.stiff, self.damper = stiff, damper
        self.elastic, self.root = Power(1.5), Power(0.25)
        self.damping: Poly = []

    def coefficient(self, n: int, o: Poly, r: Poly) -> float:
        """K d^(3/2) + C d^(1/4) d'."""
        push = self.stiff * self.elastic.coefficient(n, o)
        if self.damper:
            self.root.coefficient(n, o)
            self.damping.append(self.damper * dot(self.root.q, r[::-1]))
            push += self.damping[n]
        return push


class Power:
    """The p-th power of a series that begins above nought."""

    def __init__(self, power: float) -> None:
        self.power = power
        self.q: Poly = []
        self.weighed: Poly = []  # j d_j

    def coefficient(self, n: int, d: Poly) -> float:
        """q_n."""
        if n == 0:
            self.q.append(d[0] ** self.power)
            return self.q[0]
        back = self.q[::-1]
        self.weighed.append(n * d[n])
        total = (self.power + 1.0) * dot(self.weighed, back) - n * dot(d[1 : n + 1], back)
        self.q.append(total / (n * d[0]))
        return self.q[n]


class Links:
    """Springs and magnets across one gap. A linear one is free + k o + c d'."""

    def __init__(self, links: tuple[PairForce, ...], room: float) -> None:
        linear = [link for link in links if link.linear]
        bounds = [link.bounds(room) for link in linear]
        self.free = at_touch(linear)
        self.stiff, self.damper = sum(k for k, _ in bounds), sum(c for _, c in bounds)
        self.terms = [link.expansion() for link in links if not link.linear]

    def coefficient(self, n: int, o: Poly, r: Poly) -> float:
        """N."""
        push = self.stiff * o[n] + self.damper * r[n] + (0.0 if n else self.free)
        return push + sum(term(n, o) for term in self.terms)
