"""The branches of a contact in the oracle with forty digits: force, and what ends each."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from mpmath import mp, mpf


class UnsupportedError(Exception):
    """The oracle does not know."""


@dataclass
class Pair:
    """A contact: N = k (d − rest) + c s in its present state; nought where it is open."""

    law: str
    k: mpf
    e: mpf
    c: mpf
    zeta: mpf
    state: str = "open"
    memory: mpf = field(default_factory=lambda: mpf(0))

    @property
    def rest(self) -> mpf:
        return (1 - self.e**2) * self.memory

    def force(self) -> tuple[mpf, mpf, mpf]:
        """Factors of d, of s, and a constant."""
        if self.state == "press":
            return self.k, mpf(0), mpf(0)
        if self.state == "on":
            return self.k, self.c, mpf(0)
        if self.state == "spring":
            steep = self.k / self.e**2
            return steep, mpf(0), -steep * self.rest
        return mpf(0), mpf(0), mpf(0)

    def watches(self) -> list[tuple[tuple[Any, Any, Any], str]]:
        """(factors of d, s, constant) that stay positive while this state holds, and the next."""
        if self.state == "press":
            return [((1, 0, 0), "open")] if self.e == 1 else [((0, 1, 0), "turn")]
        if self.state == "spring":
            return [((1, 0, -self.rest), "open"), ((-1, 0, self.memory), "climb")]
        if self.state == "on":
            pull = (self.k, self.c, 0) if self.law.startswith("push") else (1, 0, 0)
            return [(pull, "open")]
        if self.memory:  # a bumper on its way to be clear of the other
            return [((-1, 0, self.rest), "again"), ((1, 0, 0), "clear")]
        if self.state == "idle":
            return [((-self.k, -self.c, 0), "again"), ((1, 0, 0), "clear")]
        return [((-1, 0, 0), "touch")]


def damping(law: str, e: mpf) -> mpf:
    """ζ, by halving the definition: what the damped oscillator returns is e."""
    if e == 1:
        return mpf(0)
    if law != "push-only":
        return mpf(1) if e == 0 else -mp.log(e) / mp.sqrt(mp.pi**2 + mp.log(e) ** 2)

    def returned(z: mpf) -> mpf:
        if z < 1:
            return mp.exp(-2 * z * mp.acos(z) / mp.sqrt(1 - z * z))
        return mp.exp(-2 * z * mp.acosh(z) / mp.sqrt(z * z - 1))

    low, high = mpf(0), mpf(1)
    if returned(mpf("1.0000001")) > e:
        low, high = mpf("1.0000001"), 1 / mp.sqrt(e) + 2
    elif returned(mpf("0.9999999")) < e:
        high = mpf("0.9999999")
    for _ in range(220):
        middle = (low + high) / 2
        low, high = (middle, high) if returned(middle) > e else (low, middle)
    return low
