"""Where things stand in the picture of the world: one layout for wide pages, one for phones.

    velocity lanes        one per cart, at the top
    mass, box, springs    on the track
    beam                  with the names of the contact forces while bodies touch
    ruler                 metres
    tape                  of the reader's own ruler, where the scene has one
    legend                what a force arrow and a velocity arrow of one unit look like
Lengths are SVG units, which are about pixels. The layout never changes while a page lives.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

from sim.pages.widget.reach import picture_window
from sim.pages.widget.scale_of import Scales
from sim.scene.fields import is_word

WIDTH = {"wide": 720.0, "narrow": 350.0}
ARROWS = {"wide": (100.0, 72.0), "narrow": (58.0, 44.0)}  # the longest of force, of velocity
MARGIN = 12.0  # beside an open end
WALL = 36.0  # beside a wall where no forces are drawn
BESIDE_WALL = 16.0  # more than the longest arrow of a force on it
LANE = 21.0
ABOVE = 33.0  # from the top of the tallest box to the lowest velocity arrow
BEAM_ROW = 21.0
ROW = 21.0  # of the force of an effect, under the track
BEAM = 8.0  # without names of forces
BASELINE = 15.0  # of the letters in a row, from its top
RULER = 34.0
LEGEND = 21.0
WORD = 8.0  # more of it where “scale:” stands above its arrows
TAPE = 26.0
HEAD = 14.0  # above the highest velocity arrow
FEW = 3  # carts; with more, all forces of one kind share a row
FROM_ABOVE = ("incline", "push", "friction", "drag")  # rows of other kinds stand below these
TILT = 24.0  # for a wedge that shows the slope, between ruler and legend
UNDER_TILT = 10.0  # from the foot of the wedge to the legend
SIGN = 65.0  # a mass takes at most so much width in any font, such as “A: 0.25 kg”
LETTER = 8.0  # of a name that is a word, as “truck”
MOST_RANKS = 3
MOST_LANES = {"wide": 4, "narrow": 8}  # on a phone the fifth cart is near enough to meet the first
STAGGER = 17.0  # from one line of masses to the next, clear in any font


@dataclass(frozen=True, slots=True)
class Layout:
    """One picture. A position x (m, as the camera sees it) is drawn at origin + x · scale."""

    kind: str  # wide | narrow
    width: float
    height: float
    origin: float
    scale: float  # units per metre
    low: float  # m, left edge of the open part of the picture
    high: float  # m
    lanes: int  # heights at which velocity arrows are drawn, so that neighbours clear
    ranks: int  # heights at which masses are written, for the same reason
    stagger: float  # from one rank to the next
    track: float  # y of the top of the beam, on which the carts stand
    rows: tuple[float, ...]  # y of the force names on the beam, by contact
    beam: float  # height of the beam
    force: float  # length of an arrow of the full force scale
    velocity: float  # length of an arrow of the full velocity scale
    slots: Mapping[str, float]  # y of the forces of effects, by “kind cart”
    tape: float  # y of the tape of a reader's ruler; 0: none
    tilt: float  # y of the foot of the wedge that shows a slope
    above: bool  # whether “scale:” stands above its arrows, for want of room beside them

    def as_dict(self) -> dict[str, Any]:
        """Plain values for the page."""
        return asdict(self)

    def at(self, x: float) -> float:
        """Drawing coordinate of a position in m."""
        return self.origin + x * self.scale


def lay_out(
    header: Mapping[str, Any],
    scales: Scales,
    *,
    kind: str,
    camera: float,
    forces: bool,
    tape: bool = False,
) -> Layout:
    """The layout for `kind` wide or narrow."""
    wide = kind == "wide"
    width, (force, velocity) = WIDTH[kind], ARROWS[kind]
    count = len(header["bodies"])
    low, high = picture_window(header, camera)
    track = header["track"]
    wall = force + BESIDE_WALL if forces and scales.force else WALL
    left = wall if track["left"] == "wall" else MARGIN
    right = wall if track["right"] == "wall" else MARGIN
    scale = (width - left - right) / (high - low)
    lanes = min(count, MOST_LANES[kind])
    closest = min(b["length"] for b in header["bodies"]) * scale
    words = (len(b["name"]) for b in header["bodies"] if is_word(b["name"]))
    sign = SIGN + LETTER * max(words, default=0)
    ranks = min(count, MOST_RANKS, math.ceil(sign / closest))
    top = HEAD + (lanes - 1) * LANE + ABOVE + STAGGER * (ranks - 1) + scales.tallest
    contacts = header["contacts"]
    walled = wall_contacts(header)
    crowded = (len(contacts) > 1 and count > 2) or any(walled)
    has_forces = forces and scales.force > 0  # and their scale
    above = scales.may_tear if wide else has_forces
    row_count = (2 if crowded else 1) if has_forces else 0
    acting = slots(header, top + BEAM_ROW * row_count) if has_forces else {}
    beam = (BEAM_ROW * row_count + ROW * len(set(acting.values()))) or BEAM
    foot = top + beam + RULER + (TAPE if tape else 0.0)
    tilted = sum(effect["kind"] == "incline" for effect in header["effects"])
    return Layout(
        kind=kind,
        width=width,
        height=foot + LEGEND + (WORD if above else 0.0) + TILT * tilted,
        origin=left - low * scale,
        scale=scale,
        low=low,
        high=high,
        lanes=lanes,
        ranks=ranks,
        stagger=STAGGER,
        track=top,
        rows=tuple(
            top + BEAM_ROW * (0 if wall else k % max(row_count, 1)) + BASELINE
            for k, wall in enumerate(walled)
        ),
        beam=beam,
        force=force,
        velocity=velocity,
        slots=acting,
        tape=foot - TAPE / 2 if tape else 0.0,
        tilt=foot + TILT - UNDER_TILT,
        above=above,
    )


def wall_contacts(header: Mapping[str, Any]) -> list[bool]:
    """For each contact whether it is with a wall: its two names stand in two rows on the track."""
    return [c["bodies"][0] == "left" or c["bodies"][1] == "right" for c in header["contacts"]]


def slots(header: Mapping[str, Any], top: float) -> dict[str, float]:
    """y of the row of each force on one cart, by “kind cart”, from `top` downwards.

    What is switched off counts too: a switch must not move the ground under the carts.
    """
    many = len(header["bodies"]) > FEW
    acting = [effect for effect in header["effects"] if not effect["between"]]
    kinds = {effect["kind"] for effect in acting}
    rows: dict[str, float] = {}
    row = 0
    for kind in [*(k for k in FROM_ABOVE if k in kinds), *sorted(kinds.difference(FROM_ABOVE))]:
        acted_on = {name for effect in acting if effect["kind"] == kind for name in effect["carts"]}
        names = [body["name"] for body in header["bodies"] if body["name"] in acted_on]
        for name in names:
            rows[f"{kind} {name}"] = top + ROW * (row + 0.5)
            row += 0 if many else 1
        row += 1 if many and names else 0
    return rows
