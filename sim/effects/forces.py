"""What an effect can do to the carts of a run. An effect overrides what it needs of `Acting`.

    BodyForce         on one cart          F = steady − linear v − quadratic v |v|
    CoulombFriction   on one cart          at most `static` at rest, `kinetic` against the motion
    PairForce         between neighbours   N(gap, its rate), pushes them apart when positive
    EnergyRelease     energy set free between two touching carts: at one instant, or by a
                      LooseForce, a PairForce that ends for good

Every solver knows these four, so an effect brings formulas and no solver. They are imported only
where a scene lists the effect.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from importlib import import_module
from itertools import pairwise
from typing import Any, ClassVar, Protocol

from sim.scene.model import Scene

Poly = list[float]
"""Coefficients of 1, t, t² …, t in s."""

FRICTION = "friction"
"""All dry friction on a cart is booked under this kind."""


@dataclass(frozen=True, slots=True)
class BodyForce:
    """F = steady − linear v − quadratic v |v| on one cart, in N; + is to the right."""

    kind: str
    steady: float = 0.0  # N
    linear: float = 0.0  # N s/m
    quadratic: float = 0.0  # N s²/m²

    def at(self, v: Any) -> Any:
        """N at the velocity v [m/s], a number or an array of many."""
        return self.steady + resistance(self.linear, self.quadratic, v)


def resistance(linear: float, quadratic: float, v: Any) -> Any:
    """N. −linear v − quadratic v |v|."""
    return -(linear + quadratic * abs(v)) * v


@dataclass(frozen=True, slots=True)
class CoulombFriction:
    """Dry friction on one cart, in N."""

    kinetic: float
    static: float


TOUCHING = 1e-12
"""m. Room that rounding leaves between two carts that touch: an exploder sets them free."""


@dataclass(frozen=True, slots=True)
class EnergyRelease:
    """`energy` [J] set free between the bodies of `gap` at `time` [s], at once or by a `spring`."""

    kind: str
    gap: int
    energy: float
    time: float
    spring: LooseForce | None = None
    index: int = 0  # its effect's place in the list of the scene


class PairForce(Protocol):
    """A force between two neighbours that acts across the gap between them."""

    kind: ClassVar[str]
    linear: ClassVar[bool]
    """Is the force linear in gap and rate? Else its power series has a radius of convergence."""

    @property
    def nearest(self) -> float:
        """m. Nearer than this it cannot be followed: the run is refused. 0: it always can."""

    def force(self, gap: float, rate: float) -> float:
        """N, pushing apart; gap in m, its rate in m/s."""

    def energy(self, gap: float) -> float:
        """J. Stored at that gap."""

    def bounds(self, gap: float) -> tuple[float, float]:
        """|dN/d gap| [N/m] and |dN/d rate| [N s/m], for the length of a step."""

    def expansion(self) -> Callable[[int, Poly], float]:
        """A function (n, overlap series up to order n + 1) -> n-th coefficient of N."""

    def damping(self) -> float:
        """N s/m. What of the force is −damping × rate: that part only takes energy."""


def at_touch(links: Iterable[PairForce]) -> float:
    """N. What linear ones would push with at no gap, by the formula that holds where they are: a
    loose spring that was let go between pressed bumpers has its reach before that."""
    return math.fsum([link.expansion()(0, [0.0, 0.0]) for link in links])


class LooseForce(PairForce, Protocol):
    """A linear force that only pushes, and falls off for good at the gap `reach` [m]."""

    reach: float
    strongest: float  # N, when it is let go

    def placed(self, gap: float) -> LooseForce:
        """The same with all its energy at this gap [m], where it is let go."""

    def impulse(self, time: float, summed: float) -> float:
        """N s in `time` [s] before it falls off; `summed` [m s] is the integral of −gap."""


class Acting:
    """One listed effect at work; `kind` is its name."""

    kind: str = ""

    def body_force(self, cart: int, t: float) -> BodyForce | None:
        """The force on a cart just after t."""
        return None

    def friction(self, cart: int) -> CoulombFriction | None:
        """The friction on a cart."""
        return None

    def pair_force(self, gap: int) -> PairForce | None:
        """The force across a gap."""
        return None

    def releases(self) -> tuple[EnergyRelease, ...]:
        """Energies set free."""
        return ()

    def switches(self) -> tuple[float, ...]:
        """s. Times at which a body force begins or ends."""
        return ()


def acting(scene: Scene) -> tuple[Acting, ...]:
    """The listed effects at work, in the order listed."""
    return tuple(
        import_module(f"sim.effects.{effect.kind}.force").act(effect, scene)
        for effect in scene.effects
    )


def checked(scene: Scene) -> tuple[Acting, ...]:
    """The same as a run begins: each is looked at once, by who counts on what `Acting` promises."""
    found = acting(scene)
    for one in found:
        _refuse_drift(one, scene)
    return found


INSIDE = 0.381966
"""Of a phase. Where a force is looked at once more: no period of whole parts repeats there."""


def _refuse_drift(one: Acting, scene: Scene) -> None:
    """A body force is a formula in v from one switch to the next. One that changes in between
    would be taken as it begins, by every solver: that is a fault of the effect, not of a scene."""
    times = sorted({0.0, *(t for t in one.switches() if 0.0 < t < scene.until)})
    for begin, end in pairwise([*times, scene.until]):
        inside = begin + INSIDE * (end - begin)
        for cart in range(len(scene.carts)):
            if one.body_force(cart, begin) != one.body_force(cart, inside):
                raise TypeError(
                    f"{one.kind}: its force on cart {cart} changes from {begin:g} to {end:g} s; "
                    "name the times in switches(): in between it is steady - b v - c v |v|"
                )
