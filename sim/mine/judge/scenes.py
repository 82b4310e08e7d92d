"""The scenes of a search: two carts on an open track that run into each other, nothing else.

Friction, slopes and walls stand on the ground, so with them a train's observer sees another scene;
without them only the law acts, and what breaks is the law's. Numbers are rounded before anything is
run: the scene that is shown is the very one that was computed.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from sim.mine.judge.chance import Chance
from sim.scene.model import Scene

LENGTH, START = 0.2, 0.4
"""m. Of a cart, and where A stands."""

AFTER = 0.8
"""s after the first touch: contacts of usual springs are over by then."""


@dataclass(frozen=True, slots=True)
class Space:
    """Where is looked: kg, m/s, m; and the numbers of the contact, if the law asks for them."""

    masses: tuple[float, float] = (0.1, 8.0)
    closing: tuple[float, float] = (0.1, 2.0)
    drift: tuple[float, float] = (-1.0, 1.0)
    gap: tuple[float, float] = (0.01, 0.5)
    stiffness: tuple[float, float] = (50.0, 1000.0)
    restitution: tuple[float, float] = (0.2, 1.0)


@dataclass(frozen=True, slots=True)
class Draft:
    """One scene of the search: kg, m/s, m from edge to edge, and the contact's numbers."""

    masses: tuple[float, float]
    velocities: tuple[float, float]
    gap: float
    stiffness: float
    restitution: float

    @property
    def closing(self) -> float:
        """m/s, above 0."""
        return self.velocities[0] - self.velocities[1]


WIDE = Space()


def at_random(chance: Chance, space: Space, wants: tuple[str, ...], usual: Draft) -> Draft:
    """Anywhere in the space; numbers that the law does not ask for stay the usual ones."""
    closing = _reaching(chance, space.closing)
    right = chance.between(*space.drift)
    return _rounded(
        Draft(
            (_reaching(chance, space.masses), _reaching(chance, space.masses)),
            (right + closing, right),
            chance.scaled(*space.gap),
            chance.scaled(*space.stiffness) if "stiffness" in wants else usual.stiffness,
            chance.between(*space.restitution) if "restitution" in wants else usual.restitution,
        )
    )


def _reaching(chance: Chance, bounds: tuple[float, float]) -> float:
    """Evenly in the logarithm; in two of three cases in the lowest or the highest eighth of it.

    What a law does only to the heaviest, or to the fastest, is found there.
    """
    low, high = bounds
    edge = (high / low) ** 0.125
    if chance.number() < 1 / 3:
        return chance.scaled(low, high)
    return (
        chance.scaled(low, low * edge)
        if chance.number() < 0.5
        else chance.scaled(high / edge, high)
    )


def near(chance: Chance, draft: Draft, space: Space, wants: tuple[str, ...]) -> Draft:
    """The same with some of its numbers changed by up to a half."""

    def other(value: float, bounds: tuple[float, float]) -> float:
        if chance.number() < 0.5:
            return value
        return min(max(value * chance.scaled(0.6, 1.6), bounds[0]), bounds[1])

    closing = other(draft.closing, space.closing)
    right = draft.velocities[1] + chance.between(-0.3, 0.3)
    right = min(max(right, space.drift[0]), space.drift[1])
    return _rounded(
        replace(
            draft,
            masses=(other(draft.masses[0], space.masses), other(draft.masses[1], space.masses)),
            velocities=(right + closing, right),
            gap=other(draft.gap, space.gap),
            stiffness=other(draft.stiffness, space.stiffness)
            if "stiffness" in wants
            else draft.stiffness,
            restitution=min(1.0, other(draft.restitution, space.restitution))
            if "restitution" in wants
            else draft.restitution,
        )
    )


def _rounded(draft: Draft) -> Draft:
    """To two digits, as somebody would write them; the closing speed stays above nought."""
    left, right = (round(v, 2) for v in draft.velocities)
    if left - right < 0.05:
        left = round(right + 0.05, 2)
    first, second = (float(f"{m:.2g}") for m in draft.masses)
    return Draft(
        (first, second),
        (left, right),
        max(0.01, round(draft.gap, 2)),
        float(f"{draft.stiffness:.2g}"),
        round(draft.restitution, 2),
    )


USUAL = Draft((2.0, 0.5), (0.4, 0.0), 0.1, 100.0, 1.0)
"""A heavy cart runs into a light one."""


def usual(scene: Scene | None = None) -> Draft:
    """What is tried first: `USUAL`, or the first two carts of a scene that run into each other."""
    if scene is None:
        return USUAL
    for k in range(1, len(scene.carts)):
        contact, closing = scene.contacts[k], -scene.approaches[k]
        if contact is None or contact.stiffness is None:
            continue
        own = contact.restitution
        numbers = replace(
            USUAL,
            stiffness=contact.stiffness,
            restitution=USUAL.restitution if own is None else own,
        )
        if closing <= 0.0:
            return numbers
        one, two = scene.carts[k - 1], scene.carts[k]
        return _rounded(
            replace(
                numbers,
                masses=(one.mass, two.mass),
                velocities=(one.velocity, two.velocity),
                gap=scene.gaps[k],
            )
        )
    return USUAL


def draft_of(scene: Mapping[str, Any]) -> Draft:
    """The draft that `plain` has made a scene of."""
    one, two = scene["carts"]["A"], scene["carts"]["B"]
    return Draft(
        (one["mass"], two["mass"]),
        (one["velocity"], two["velocity"]),
        round(two["position"] - one["position"] - LENGTH, 2),
        scene["contact"]["stiffness"],
        scene["contact"]["restitution"],
    )


def plain(draft: Draft, text: str, file: str) -> dict[str, Any]:
    """The scene as an author writes it, SI."""
    (m1, m2), (v1, v2) = draft.masses, draft.velocities
    until = round(draft.gap / draft.closing + AFTER, 1)
    return {
        "carts": {
            "A": {"mass": m1, "position": START, "velocity": v1},
            "B": {"mass": m2, "position": round(START + LENGTH + draft.gap, 2), "velocity": v2},
        },
        "contact": {"law": file, "stiffness": draft.stiffness, "restitution": draft.restitution},
        "until": until,
        "laws": {file: text},
    }
