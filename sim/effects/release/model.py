"""release, in the program in plain Python: at one instant, or by springs where a scene has one."""

from __future__ import annotations

import math
from dataclasses import replace

from sim.effects.forces import TOUCHING
from sim.effects.plain_model import Piece, Row
from sim.effects.where import gap_of, pair_of
from sim.scene.effects import Effect
from sim.scene.model import Scene

LATCH = f"""

for k, (left, right, *_) in enumerate(contacts):  # a latch holds what is to be released
    latched = any((left, right) == (a, b) for _, a, b, *_ in releases)
    if latched and gap(left, right) <= {TOUCHING:g} and approach(left, right) == 0:
        stuck.add(k)
"""


def _rows(effect: Effect, scene: Scene) -> list[Row]:
    n = effect.numbers
    return [(n["at"], *pair_of(effect, scene), n["energy"])]


AT_ONCE = Piece(
    name="releases",
    says="when, left, right, energy in J",
    rows=_rows,
    after="""\
    for when, left, right, energy in releases:
        k = [row[:2] for row in contacts].index((left, right))
        if t - dt <= when < t and gap(left, right) < 1e-6:
            stuck.discard(k)
            s = -approach(left, right)
            more = sqrt(s * s + 2 * energy * light(left, right)) - s
            kick(left, right, more / light(left, right))
"""
    + LATCH,
    joins=True,
)

SILENT = """\
        if s > 0:
            parted.discard(k)
        if k in parted:
            continue
"""
PARTED = "parted = set()  # bumpers that a release has parted push no more until pressed again\n"


def _parting(piece: Piece) -> Piece:
    """For bumpers that may overlap at that time."""
    line = next(one for one in piece.after.splitlines() if one.strip().startswith("more = "))
    pad = line[: len(line) - len(line.lstrip())]
    part = f"{pad}if gap(left, right) < 0:\n{pad}    parted.add(k)\n"
    before, sign, latch = piece.after.partition("\n\n\n")
    after = before.replace(line, part + line) + sign + PARTED + latch.removeprefix("\n")
    return replace(piece, after=after, contact=SILENT)


def _with_springs(effect: Effect, scene: Scene) -> list[Row]:
    return [(*row, effect.numbers.get("stiffness")) for row in _rows(effect, scene)]


def _shortest(effect: Effect, scene: Scene) -> float:
    k, gap = effect.numbers.get("stiffness"), gap_of(effect, scene)
    masses = (scene.carts[gap - 1].mass, scene.carts[gap].mass)
    return 0.5 * math.pi / math.sqrt(k * sum(1.0 / m for m in masses)) if k else math.inf


BY_SPRINGS = Piece(
    name="releases",
    says="when, left, right, energy in J, stiffness of its spring in N/m (None: all at once)",
    rows=_with_springs,
    force="""\
    for left, right, stiffness, length in let_go:
        push_apart(force, left, right, stiffness * (length - gap(left, right)))
""",
    after="""\
    let_go[:] = [one for one in let_go if gap(*one[:2]) < one[3]]  # at full length they fall off
    for when, left, right, energy, stiffness in releases:
        k = [row[:2] for row in contacts].index((left, right))
        if t - dt <= when < t and gap(left, right) < 1e-6:
            stuck.discard(k)
            if stiffness:
                let_go.append((left, right, stiffness, sqrt(2 * energy / stiffness)))
            else:
                s = -approach(left, right)
                more = sqrt(s * s + 2 * energy * light(left, right)) - s
                kick(left, right, more / light(left, right))


let_go = []  # springs that push: left, right, stiffness in N/m, full length in m
"""
    + LATCH.removeprefix("\n\n"),
    joins=True,
    shortest=_shortest,
)


def piece(scene: Scene) -> Piece:
    """Springs only where the scene has one."""
    own = [effect for effect in scene.effects if effect.kind == "release"]
    by_springs = any("stiffness" in effect.numbers for effect in own)
    found = BY_SPRINGS if by_springs else AT_ONCE
    own = [effect for effect in own if "stiffness" not in effect.numbers]
    lasting = (scene.contacts[gap_of(effect, scene)] for effect in own)
    return _parting(found) if any(one is not None and one.stiffness for one in lasting) else found
