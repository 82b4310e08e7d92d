"""Neighbours as a stepping method sees them, and what one evaluation of their forces tells."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sim.dynamics.result.outcome import UnsolvedError
from sim.effects.forces import Acting, LooseForce, PairForce
from sim.laws.contact_law import reduced_mass
from sim.laws.lookup import contact_law
from sim.laws.stepping import SteppedContact
from sim.scene.model import Contact, Scene
from sim.scene.said import said

PerCart = list[Any]
"""One number per cart or gap; or one array, where many runs go on at once."""


@dataclass(slots=True)
class Pair:
    """The neighbours of one gap; a wall has the index None. `force` is None without duration."""

    gap: int
    left: int | None
    right: int | None
    room: float  # m, at the start
    contact: Contact
    mu: float
    force: SteppedContact | None
    links: tuple[PairForce, ...]
    loose: tuple[LooseForce, ...] = ()  # those of them that fall off

    @property
    def apart(self) -> bool:
        """Does a force without a limit keep the two from ever touching?"""
        return any(link.nearest for link in self.links)


@dataclass(frozen=True, slots=True)
class Detail:
    """One evaluation: forces in N per gap and cart, power in W that dampers take, velocities."""

    push: PerCart
    links: dict[tuple[str, int], float]
    joints: dict[int, float]  # between two that move as one, held bumpers apart
    outside: dict[tuple[str, int], float]
    warming: float
    damped: dict[str, float]
    v: PerCart


def pair_of(scene: Scene, gap: int, effects: Sequence[Acting]) -> Pair | None:
    """The neighbours of a gap with what acts between them; None at an open end."""
    contact = scene.contacts[gap]
    if contact is None:
        return None
    left = gap - 1 if gap > 0 else None
    right = gap if gap < len(scene.carts) else None
    masses = (math.inf if k is None else scene.carts[k].mass for k in (left, right))
    mu = reduced_mass(*masses)
    law = contact_law(contact)
    links = (one.pair_force(gap) for one in effects)
    return Pair(
        gap,
        left,
        right,
        scene.gaps[gap],
        contact,
        mu,
        law.stepping(mu) if law is not None else None,
        tuple(link for link in links if link is not None),
    )


def link_force(link: PairForce, d: Any, rate: Any, *, lanes: bool) -> Any:
    """N, of a spring or magnets at overlap d [m] and rate [m/s]; `lanes`: of many runs."""
    if not lanes:
        if d >= 0.0 and link.nearest:
            raise UnsolvedError(
                said(
                    "a step took two carts through each other, where {effect} have no force",
                    effect=link.kind,
                ),
                said("a shorter step"),
                0.0,
                (),
            )
        return link.force(-d, -rate)
    import numpy as np

    return np.array([link.force(-a, -b) for a, b in zip(d.tolist(), rate.tolist(), strict=True)])
