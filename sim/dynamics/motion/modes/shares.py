"""What a state of a row gives to its modes, once for all states between the same springs.

For the same masses, springs and dampers the share of a mode is a fixed sum over overlaps and rates.
Of a row that alternates between few sets of formulas, as one does whose bumpers rattle, all are
computed once and kept. Contacts that are locked push with a fixed part of what presses the block of
bodies between them from its two sides,

    N_k = (1 − f) N_left + f N_right + what is steady ,     f the part of its mass left of gap k ,

f = 0 or 1 where the block stands fast.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from operator import mul

from sim.dynamics.motion.modes.normal_modes import Mode, Segment, modes
from sim.dynamics.motion.modes.started import Shape, shape_of
from sim.dynamics.motion.rest import Balance, blocks, segments


@dataclass(frozen=True, slots=True)
class Block:
    """Bodies that move as one: the gaps beside them, None at an open end; 1/kg, 0: it stands."""

    bodies: range
    left: int | None
    right: int | None
    inverse: float

    def load(self, steady: list[float]) -> float:
        """N. All that acts on it besides its neighbours."""
        return math.fsum([steady[i] for i in self.bodies])


@dataclass(frozen=True, slots=True)
class Part:
    """One mode in one gap: its strain, and what rate and strain there give to its share."""

    gap: int
    strain: complex
    of_strain: complex
    of_rate: complex


@dataclass(frozen=True, slots=True)
class Swings:
    """All modes of a row: rates [1/s], parts by mode; the block of each body, f of each gap.

    And what each overlap and its rate, each force and its growth, each velocity has of them.
    """

    rates: tuple[complex, ...]
    parts: tuple[tuple[Part, ...], ...]
    block: tuple[Block, ...]
    left_mass: tuple[float, ...]
    over: tuple[Shape, ...]
    closing: tuple[Shape, ...]
    push: tuple[Shape, ...]
    growth: tuple[Shape, ...]
    speed: tuple[Shape, ...]
    ways: tuple[tuple[float, ...], ...]  # of each overlap, |b/z|
    stiffest: tuple[int, ...]  # gaps, the stiffest first
    fastest: float  # 1/s, of what rings; 0 where nothing does
    pace: float  # 1/s, of all; 1 where there is none


@lru_cache(maxsize=512)
def swings(
    masses: tuple[float, ...],
    kappa: tuple[float, ...],
    gamma: tuple[float, ...],
    locked: tuple[bool, ...],
) -> Swings | None:
    """None where modes do not tell the motion. inf kg: it stands fast."""
    if any(k <= 0.0 and not held for k, held in zip(kappa, locked, strict=True)):
        return None
    fixed = [m == math.inf for m in masses]
    balance = Balance([0.0] * len(masses), list(kappa), [0.0] * len(kappa), fixed, list(locked))
    found = _blocks(masses, balance)
    if found is None:
        return None
    block, left_mass = found
    rates: list[complex] = []
    parts: list[tuple[Part, ...]] = []
    for own, near in segments(balance):
        segment = Segment(
            tuple(math.fsum([masses[i] for i in block]) for block in own),
            (0.0,) * len(own),
            tuple(0.0 if k is None else kappa[k] for k in near),
            tuple(0.0 if k is None else gamma[k] for k in near),
        )
        own_modes = modes(segment) if segment.anchored or len(own) > 1 else ()
        if own_modes is None or any(mode.rate == 0.0 or mode.norm == 0.0 for mode in own_modes):
            return None
        rates += [mode.rate for mode in own_modes]
        parts += [_parts(mode, segment, near) for mode in own_modes]
    return _swings_of(tuple(rates), tuple(parts), block, left_mass, kappa, gamma, locked)


def _swings_of(
    rates: tuple[complex, ...],
    parts: tuple[tuple[Part, ...], ...],
    block: tuple[Block, ...],
    left_mass: tuple[float, ...],
    kappa: tuple[float, ...],
    gamma: tuple[float, ...],
    locked: tuple[bool, ...],
) -> Swings:
    """The `Swings`: shapes of overlap, closing speed, force and velocity, from the strains."""
    count = len(kappa)
    over = [[0j] * len(rates) for _ in range(count)]
    for j, own in enumerate(parts):
        for one in own:
            over[one.gap][j] = one.strain
    bent = [  # N''
        tuple([(k + c * z) * y if c else k * y for z, y in zip(rates, own, strict=True)])
        for k, c, own in zip(kappa, gamma, over, strict=True)
    ]
    nothing = (0j,) * len(rates)

    def beside(gap: int | None) -> tuple[complex, ...]:
        return nothing if gap is None else bent[gap]

    for k in range(count):
        if locked[k]:
            held, f = block[k], left_mass[k]
            two = zip(beside(held.left), beside(held.right), strict=True)
            bent[k] = tuple([(1.0 - f) * a + f * b for a, b in two])
    speeds = [
        tuple(
            [
                (x - y) * own.inverse / z
                for x, y, z in zip(beside(own.left), beside(own.right), rates, strict=True)
            ]
        )
        for own in block
    ]
    closing = [tuple([z * y for z, y in zip(rates, own, strict=True)]) for own in over]
    return Swings(
        rates, parts, block, left_mass,
        tuple(shape_of(tuple(own), rates) for own in over),
        tuple(shape_of(own, rates) for own in closing),
        tuple(shape_of(own, rates) for own in bent),
        tuple(shape_of(tuple(map(mul, own, rates)), rates) for own in bent),
        tuple(shape_of(own, rates) for own in speeds),
        tuple(tuple([abs(y / z) for y, z in zip(own, rates, strict=True)]) for own in over),
        tuple(sorted(range(count), key=lambda k: -kappa[k])),
        max((abs(z) for z in rates if z.imag), default=0.0),
        max(map(abs, rates), default=1.0),
    )  # fmt: skip


def _parts(mode: Mode, segment: Segment, near: list[int | None]) -> tuple[Part, ...]:
    z = mode.rate
    twice = 1.0 if z.imag == 0.0 else 2.0
    found = []
    for k, kappa, push, strain in zip(near, segment.kappa, mode.push, mode.strain, strict=True):
        if k is not None:
            of_strain = -twice * kappa * strain / (z * mode.norm)
            found.append(Part(k, strain, of_strain, -twice * push / (z * z * mode.norm)))
    return tuple(found)


def _blocks(
    masses: tuple[float, ...], balance: Balance
) -> tuple[tuple[Block, ...], tuple[float, ...]] | None:
    """The block of each body, and f of each gap; None where a block is held from both sides."""
    found: list[Block] = []
    left_mass = [0.0] * len(balance.locked)
    for own in blocks(balance.locked):
        first, last = own[0], own[-1]
        still = [i for i in own if balance.fixed[i]]
        if len(still) > 1:
            return None
        whole = math.fsum(masses[i] for i in own)
        for k in range(first, last):
            if still:
                left_mass[k] = 0.0 if k < still[0] else 1.0
            else:
                left_mass[k] = math.fsum(masses[i] for i in range(first, k + 1)) / whole
        left = first - 1 if first > 0 else None
        right = last if last < len(balance.locked) else None
        found += [Block(own, left, right, 0.0 if still else 1.0 / whole)] * len(own)
    return tuple(found), tuple(left_mass)
