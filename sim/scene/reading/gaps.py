"""Gaps between neighbours at the start, exact; and what is wrong where they overlap."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from fractions import Fraction

from sim.scene.model import Track
from sim.scene.problem import Problem
from sim.scene.said import said
from sim.scene.track import body_name


def gaps_of(
    exact: Mapping[str, Mapping[str, Fraction]],
    names: list[str],
    track: Track,
    length: Fraction | None,
) -> list[Fraction | None]:
    """Edge-to-edge gaps, exact, left to right; None on an open side."""
    left_edges = [exact[n]["position"] - exact[n]["length"] / 2 for n in names]
    right_edges = [exact[n]["position"] + exact[n]["length"] / 2 for n in names]
    first = left_edges[0] if track.left == "wall" else None
    last = length - right_edges[-1] if track.right == "wall" and length is not None else None
    inner = [b - a for a, b in zip(right_edges[:-1], left_edges[1:], strict=True)]
    return [first, *inner, last]


def approaches(
    exact: Mapping[str, Mapping[str, Fraction]], names: list[str], track: Track
) -> tuple[float, ...]:
    """m/s. How fast each gap closes at the start, left to right; walls stand still."""
    velocities = [exact[name]["velocity"] for name in names]
    first = float(velocities[0]) if track.left == "wall" else 0.0
    last = float(-velocities[-1]) if track.right == "wall" else 0.0
    inner = (float(b - a) for a, b in itertools.pairwise(velocities))
    return (first, *inner, last)


def refuse_overlap(
    k: int,
    gap: Fraction,
    names: list[str],
    track: Track,
    released: set[frozenset[str]],
    problems: list[Problem],
    *,
    at_once: bool,
) -> None:
    """One problem for a gap that is negative, unless a release names its two."""
    left = names[k - 1] if k > 0 else "left"
    right = names[k] if k < len(names) else "right"
    if frozenset((left, right)) in released:
        return
    cart = right if k < len(names) else left
    length = f"{float(-gap):.3g} m"
    if k in (0, len(names)):
        what = said(
            "{cart} reaches into {thing} by {length} at the start",
            cart=cart,
            thing=body_name("left" if k == 0 else "right", track),
            length=length,
        )
        hint = said("move it away: a position is that of the cart's centre")
    else:
        what = said(
            "{one} and {other} overlap by {length} at the start",
            one=left,
            other=right,
            length=length,
        )
        hint = said("move them apart: a position is that of the cart's centre")
    if not at_once:
        hint = said("{advice}; start: {overlap: true} allows it", advice=hint)
    problems.append(Problem(("carts", cart, "position"), "overlap", what, hint))
