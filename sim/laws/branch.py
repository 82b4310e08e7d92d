"""Linear parts of a contact force, and what ends each: words that every solver of rows knows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Cause = Literal["apart", "turn", "climb", "touch", "clear", "off", "nearest", "halt", "slip"]
"""What ends a step:

apart   a contact's force is zero               touch   a linked pair reaches its bumpers
turn    a bumper is deepest                     clear   a linked pair's old overlap is gone
climb   it is back at its old depth, or, with   halt    a sliding body comes to v = 0
        e = 0, pressed as hard as at its        slip    static friction has reached its limit
        greatest overlap                     off     a loose spring has its natural length
nearest a pair that never touches has
        come as near as it will
"""


@dataclass(frozen=True, slots=True)
class Branch:
    """One linear branch of a contact force; kappa in N/m, gamma in N s/m, rest in m.

    `locked`: the overlap stays as it is, and the force is whatever that takes (a bumper with e = 0
    at its greatest overlap). The forces of neighbouring locked gaps solve a tridiagonal system.
    """

    kappa: float
    gamma: float
    rest: float
    locked: bool = False

    def force(self, over: float, rate: float) -> float:
        """N, at overlap [m] and its rate [m/s]; 0 where locked: no formula gives it."""
        return self.kappa * (over - self.rest) + self.gamma * rate


LOCKED = Branch(0.0, 0.0, 0.0, locked=True)
APART = Branch(0.0, 0.0, 0.0)
"""A gap that is only linked: no contact force."""

CURVED = Branch(0.0, 0.0, 0.0)
"""No linear branch: the force follows from the law itself."""


@dataclass(frozen=True, slots=True)
class Guard:
    """Something that ends a step when it happens in a gap: `of` falls, or rises, to `level`.

    `of`: the contact's force [N], the overlap [m], its rate [m/s], or the `push` [N] that spring
    and damper of a pair that separated with an overlap would have.
    """

    cause: Cause
    of: Literal["force", "overlap", "rate", "push"]
    rises: bool = False
    level: float = 0.0


APART_AT_NO_FORCE = (Guard("apart", "force"),)
APART_AT_NO_OVERLAP = (Guard("apart", "overlap"),)
