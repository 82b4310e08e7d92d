"""What an effect can do to the carts of a run. An effect overrides what it needs of `Acting`.

    Pull   a force on one cart          F = steady − linear v − quadratic v |v|
    Grip   Coulomb friction of a cart   at most `static` at rest, `kinetic` against the motion
    Link   a force between neighbours   N(room, closing speed), pushes them apart when positive
    Burst  energy set free between two touching carts at one instant

Every solver knows these four, so an effect brings formulas and no solver.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar, Protocol

Poly = list[float]
"""Coefficients of 1, t, t² …, t in s."""


@dataclass(frozen=True, slots=True)
class Pull:
    """F = steady − linear v − quadratic v |v| on one cart, in N; + is to the right."""

    kind: str
    steady: float = 0.0  # N
    linear: float = 0.0  # N s/m
    quadratic: float = 0.0  # N s²/m²


@dataclass(frozen=True, slots=True)
class Grip:
    """Dry friction on one cart, in N."""

    kinetic: float
    static: float


@dataclass(frozen=True, slots=True)
class Burst:
    """`energy` [J] set free between the bodies of `gap` at `time` [s]."""

    gap: int
    energy: float
    time: float


class Link(Protocol):
    """A force between two neighbours that acts across the room between them."""

    kind: ClassVar[str]

    def force(self, room: float, rate: float) -> float:
        """N, pushing apart; room in m, rate of the room in m/s."""

    def energy(self, room: float) -> float:
        """J. Stored at that room."""

    def bounds(self, room: float) -> tuple[float, float]:
        """|dN/d room| [N/m] and |dN/d rate| [N s/m], for the length of a step."""

    def expansion(self) -> Callable[[int, Poly], float]:
        """A function (n, overlap series up to order n + 1) -> n-th coefficient of N."""

    def damping(self) -> float:
        """N s/m. What of the force is −damping × rate: that part only takes energy."""


class Acting:
    """One listed effect at work; `kind` is its name."""

    kind: str = ""

    def pull(self, cart: int, t: float) -> Pull | None:
        """The force on a cart just after t."""
        return None

    def grip(self, cart: int) -> Grip | None:
        """The friction on a cart."""
        return None

    def link(self, gap: int) -> Link | None:
        """The force across a gap."""
        return None

    def bursts(self) -> tuple[Burst, ...]:
        """Energies set free."""
        return ()

    def switches(self) -> tuple[float, ...]:
        """s. Times at which a pull begins or ends."""
        return ()
