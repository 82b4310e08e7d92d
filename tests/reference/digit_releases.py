"""Exploders in the oracle with forty digits: latched carts, and what parts them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from mpmath import mp, mpf

from tests.reference.digit_pairs import UnsupportedError
from tests.reference.digit_row import NOTHING, DigitRow, Group


@dataclass
class Exploder:
    """Between the two at gap k."""

    k: int
    energy: mpf  # J
    at: mpf  # s
    stiffness: mpf | None  # N/m


def exploders(row: DigitRow) -> list[Exploder]:
    """All of a scene, in the order of their times."""
    found = []
    for effect in row.scene.effects:
        if effect.kind == "release":
            n = effect.numbers
            k = next(k for k in range(row.n + 1) if row.scene.names_at(k) == effect.between)
            stiff = mpf(n["stiffness"]) if "stiffness" in n else None
            found.append(Exploder(k, mpf(n["energy"]), mpf(n["at"]), stiff))
    return sorted(found, key=lambda one: one.at)


def latch(row: DigitRow, waiting: list[Exploder]) -> None:
    """Who touches at the start with one velocity is one body until then."""
    for one in waiting:
        d, s = row.overlap(one.k)
        if one.k not in row.joined and d >= 0 and s == 0:
            if d > 0:
                raise UnsupportedError("squeezed bumpers under a latch")
            left, right = row.group(one.k - 1), row.group(one.k)
            row.joined.add(one.k)
            if left is None or right is None:
                stuck = left or right
                assert stuck is not None
                stuck.fixed = True
            else:
                row.groups.remove(right)
                left.carts += right.carts
                left.fixed = left.fixed or right.fixed
    row.dampers()


def let_go(row: DigitRow, one: Exploder) -> None:
    """½ μ w′² = ½ μ w² + E, or a spring that holds E."""
    if one.k in row.joined:
        _split(row, one.k)
    else:
        d, _ = row.overlap(one.k)
        if d < -(mpf(10) ** -12):
            return
        pair = row.pairs[one.k]
        if abs(d) > NOTHING or (pair is not None and pair.state != "open"):
            raise UnsupportedError("bumpers that are not just touching are let go")
    row.tell("release", row.scene.names_at(one.k))
    if one.stiffness is not None:
        length = mp.sqrt(2 * one.energy / one.stiffness)
        if one.k in row.springs or row.loose.get(one.k):
            raise UnsupportedError("a second spring in a gap")
        row.loose[one.k] = length
        row.springs[one.k] = (one.stiffness, mpf(0), one.stiffness * length)
        return
    left, right = row.group(one.k - 1), row.group(one.k)
    w, mu = -row.overlap(one.k)[1], row.mu(one.k)
    impulse = mu * (mp.sqrt(w * w + 2 * one.energy / mu) - w)
    for group, way in ((left, -1), (right, 1)):
        if group is not None and not group.fixed:
            group.v += way * impulse / row.mass(group)
            group.held = False


def _split(row: DigitRow, k: int) -> None:
    one: Any = row.group(k - 1) or row.group(k)
    row.joined.discard(k)
    left = [c for c in one.carts if c < k]
    right = [c for c in one.carts if c >= k]
    row.groups.remove(one)
    for carts in (left, right):
        if carts:
            ends = (0 in row.joined and 0 in carts, row.n in row.joined and row.n - 1 in carts)
            row.groups.append(Group(carts, one.v, any(ends), one.held, one.sliding))
    row.groups.sort(key=lambda group: group.carts[0])
    row.dampers()
