"""A scene: the one description that lessons, commands, tests and benchmarks share.

    left wall   [ A ]        [ B ]   right wall
      x = 0  -----------------------> x = track.length       + is to the right

Everything here is frozen; a changed scene is a new one. Positions are those of cart centres.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Literal

from sim.scene.effects import Effect

End = Literal["open", "wall"]
Thing = Literal["wall", "foam", "spring", "board"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Cart:
    """One cart at t = 0."""

    name: str
    mass: float  # kg, > 0
    position: float  # m, of the centre
    velocity: float  # m/s, + is to the right
    length: float  # m, bumpers included
    bumper_length: float  # m, of the bumper at each end


@dataclass(frozen=True, slots=True, kw_only=True)
class Track:
    """The air track and its ends. A wall stands at x = 0 or at x = length."""

    left: End = "open"
    right: End = "open"
    length: float | None = None  # m; None: without limit
    left_is: Thing = "wall"  # what a wall is called and drawn as; its motion does not know
    right_is: Thing = "wall"


@dataclass(frozen=True, slots=True, kw_only=True)
class Contact:
    """How two neighbours push each other while they touch.

    `stiffness` is in N/m (hertz: N/m^1.5) and None for laws without a duration; `restitution` is
    the asked-for ratio of separation to approach speed, None for velcro, which never separates.
    """

    law: str
    restitution: float | None
    stiffness: float | None

    @property
    def written(self) -> bool:
        """Is its law a function in a file, followed by `sim.mine` and nobody else?"""
        return self.law.endswith(".py")

    @property
    def sudden(self) -> bool:
        """Without a duration: an impulse, or a joint."""
        return self.stiffness is None

    @property
    def joins(self) -> bool:
        """Does what touches stay together?"""
        return self.restitution is None


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """Everything that a run depends on, and nothing else.

    `carts` are sorted from left to right. `contacts[k]` and `gaps[k]` belong to the k-th
    neighbourhood: gap 0 is left wall to first cart, gap n last cart to right wall. On an open side
    the contact is None and the gap infinite. Gaps and closing speeds are rounded once from exact
    decimals, so that carts that touch on paper touch here.
    """

    title: str | None
    carts: tuple[Cart, ...]
    track: Track
    common: Contact | None
    """The contact of all neighbourhoods that have no own, whether there is such a one or not."""
    contacts: tuple[Contact | None, ...]
    gaps: tuple[float, ...]  # m, edge to edge; negative: overlap
    approaches: tuple[float, ...]  # m/s, right velocity minus left; negative: closing
    effects: tuple[Effect, ...] = field(default=())
    estimates: tuple[Effect, ...] = field(default=())
    """How large what is left out would be: asked for by nobody but the estimate of its effect."""
    tolerances: Mapping[str, Fraction] = field(default_factory=dict)
    """Half widths in SI by path, ``A.mass``. A run takes the middle; a certificate the whole."""
    written: Mapping[str, str] = field(default_factory=dict)
    """Texts of laws by the name of their file, those that a contact names."""
    until: float  # s
    gravity: float  # m/s²

    def names_at(self, gap: int) -> tuple[str, str]:
        """Names of the bodies left and right of a gap; walls are ``left`` and ``right``."""
        left = self.carts[gap - 1].name if gap > 0 else "left"
        right = self.carts[gap].name if gap < len(self.carts) else "right"
        return left, right
