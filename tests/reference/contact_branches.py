"""The contact laws as little automata: which formula holds now, and what ends it.

d [m] is the overlap of two bumpers, s = d' [m/s]. Written from the definitions, to be integrated;
shares nothing with `sim.dynamics`. A watch is (value, next state): the state holds while value is
not negative.

    bumper      press   N = k d                       until d' < 0: then M = d is remembered
                spring  N = (k/e²)(d − (1 − e²) M)    until N = 0, or d is back at M
                open    N = 0                         until d passes (1 − e²) M; M is forgotten
                                                      where d = 0
    paper       on      N = k d + c d'                until d = 0
    hertz       on      N = k d^1.5 + C d^0.25 d'      until d = 0
    push-only   on      N = k d + c d'                until N = 0; idle while N would pull
    all         spent   N = 0, after a release        until d = 0
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from tests.reference.force_laws import zeta_for_zero_force, zeta_printed

DEAD = 1e-7
"""Restitution. A bumper that gives back less than this gives back nothing (`dead_bumpers`)."""


class UnsupportedError(Exception):
    """The oracle does not know, or would need too long."""


@dataclass(frozen=True)
class Branch:
    """State of one contact."""

    law: str
    k: float
    e: float
    zeta: float
    c: float = 0.0  # N s/m
    state: str = "open"
    memory: float = 0.0

    def between(self, mu: float) -> Branch:
        """The same law between bodies of that reduced mass [kg]."""
        factor = math.sqrt(5) if self.law == "hertz" else 2
        return replace(self, c=factor * self.zeta * math.sqrt(self.k * mu))

    def force(self, d: float, s: float) -> float:
        if self.state == "on" and self.law == "hertz":
            d = max(d, 0.0)
            return self.k * d**1.5 + self.c * d**0.25 * s
        if self.state == "on":
            return self.k * d + self.c * s
        if self.state == "press":
            return self.k * d
        if self.state == "spring":
            return self.k / self.e**2 * (d - self.rest)
        return 0.0

    @property
    def rest(self) -> float:
        return (1 - self.e**2) * self.memory

    def rates(self, mu: float) -> float:
        """1/s. The fastest that this contact can be."""
        steep = self.k / self.e**2 if self.law == "bumper" and self.e > DEAD else self.k
        return math.sqrt(steep / mu) + 2 * self.c / mu

    def watches(self, d: float, s: float) -> list[tuple[float, str]]:
        if self.state == "spent":
            return [(d, "clear"), (-s, "pressed again")]
        if self.law == "bumper":
            return {
                "open": [(self.rest - d, "spring"), (d, "clear")]
                if self.memory
                else [(-d, "press")],
                "press": [(d, "clear")] + ([(s, "turn")] if self.e < 1 else []),
                "spring": [(d - self.rest, "open"), (self.memory - d, "press")],
            }[self.state]
        if self.state == "open":
            return [(-d, "on")]
        if self.law in ("paper", "hertz"):
            return [(d, "open")]
        pull = -(self.k * d + self.c * s) / self.k
        if self.state == "on":
            return [(-pull, "idle"), (d, "open")]
        return [(pull, "on"), (d, "open")]

    def after(self, state: str, d: float) -> Branch:
        if state == "turn":
            return replace(self, state="spring", memory=d)
        if state == "pressed again":
            raise UnsupportedError("a contact that is pressed again before it had opened")
        if state == "clear":
            return replace(self, state="open", memory=0.0)
        return replace(self, state=state)


def begin(law: str, k: float, e: float, mu: float, d: float, s: float) -> Branch:
    """The contact of a pair at the start of a run."""
    zeta = 0.0
    if law != "bumper" and e < 1:
        zeta = zeta_for_zero_force(e) if law == "push-only" else zeta_printed(e) if e else 1.0
    branch = Branch(law, k, e, zeta).between(mu)
    if d == 0 and s > 0 and branch.c and law != "hertz":
        return replace(branch, state="on")  # its damper pushes at once: that may hold a cart
    if d <= 0:
        return branch
    if law == "bumper":
        return replace(branch, state="press" if s > 0 or e == 1 else "spring", memory=d)
    idle = law.startswith("push") and k * d + branch.c * s <= 0
    return replace(branch, state="idle" if idle else "on")
