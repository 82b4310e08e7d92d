"""The kinds of scenes at which an engine of contacts breaks, each drawn from a number.

Every kind aims at one thing that the engine has to decide: who carries, who slides, who sticks, who
parts, when a rattle ends, what rounding means at another scale.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from random import Random

from tests.fuzz.acting import a_friction, a_push, a_spring, any_effect
from tests.fuzz.classroom import classroom
from tests.fuzz.rows import (
    FINITE,
    Plain,
    bodies,
    contact,
    overlapped,
    pair,
    row,
)
from tests.fuzz.units import scaled
from tests.one_slope import one_slope


def rest_on_slope(dice: Random) -> Plain:
    """A row at rest, or nearly, presses itself or a wall; some hold themselves."""
    plain = row(dice, least=2, speeds=(0.0, 0.0, 0.0, 0.1), rooms=(0.0, 0.0, 0.01), walls=0.7)
    angle = dice.choice([2, -2, 5, -5, 0.1, -10])
    effects = [{"incline": {"angle": f"{angle} deg"}}]
    if dice.random() < 0.7:
        effects.append(a_friction(dice, plain))
    return plain | {"effects": effects, "until": dice.choice([1, 3, 10])}


def chain(dice: Random) -> Plain:
    """Touching carts, of one kind or of many, hit from one side or from both."""
    plain = row(dice, least=3, most=8, rooms=(0.0,), speeds=(0.0,), walls=0.2)
    for cart in plain["carts"].values():
        cart["velocity"] = dice.choice([0.0, 0.0, 0.0, 1.0, -1.0])
    names = list(plain["carts"])
    plain["carts"][names[0]]["velocity"] = dice.choice([0.0, 0.5, 1.0])
    return plain


def pushes_at_edges(dice: Random) -> Plain:
    """Pushes that begin and end while carts touch, on carts that touch or do not."""
    plain = row(dice, rooms=(0.0, 0.0, 0.02))
    effects = [a_push(dice, plain) for _ in range(dice.randint(1, 3))]
    if dice.random() < 0.4:
        effects.append(a_friction(dice, plain))
    return plain | {"effects": effects}


def dead_bumpers(dice: Random) -> Plain:
    """Bumpers with e = 0 beside other contacts: held, climbed, let go."""
    plain = row(dice, least=2, laws=FINITE, rooms=(0.0, 0.0, 0.05))
    names = bodies(plain)
    pairs = plain["contact"].setdefault("pairs", {})
    for a, b in itertools.pairwise(names):
        if dice.random() < 0.6:
            e = dice.choice([0, 0, 1e-9, 1e-3])
            pairs[f"{a}-{b}"] = contact(dice, law="bumper", restitution=e)
    if dice.random() < 0.5:
        plain["effects"] = [any_effect(dice, plain, ("friction", "incline", "push", "spring"))]
    return plain


def touching_springs(dice: Random) -> Plain:
    """Springs, soft and hard, hold pairs together at the edge of contact."""
    plain = row(dice, least=2, rooms=(0.0, 0.0, 0.0, 0.01), speeds=(0.0, 0.0, 0.2, -0.2))
    effects = [a_spring(dice, plain) for _ in range(dice.randint(1, 2))]
    return plain | {"effects": effects, "until": dice.choice([1, 5])}


def magnets(dice: Random) -> Plain:
    """Magnets of whole and broken powers, alone and beside contacts."""
    plain = row(dice, least=2, rooms=(0.02, 0.1, 0.3))
    effects = [
        {
            "magnets": {
                "between": between,
                "strength": dice.choice([1e-6, 1e-5, 1e-4, 1e-3, 1e-2]),
                "power": dice.choice([1, 2, 3, 4, 2.5]),
            }
        }
        for _ in range(dice.randint(1, 2))
        if (between := pair(dice, plain, room=0.01))
    ]
    if dice.random() < 0.4:
        effects.append(any_effect(dice, plain, ("friction", "incline", "push", "drag")))
    return plain | {"effects": effects}


def springs(dice: Random) -> Plain:
    """Springs between carts apart: swings that run into bumpers and out again."""
    plain = row(dice, least=2, rooms=(0.05, 0.1, 0.2))
    effects = [a_spring(dice, plain) for _ in range(dice.randint(1, 3))]
    if dice.random() < 0.4:
        effects.append(any_effect(dice, plain, ("friction", "incline", "push", "drag")))
    return plain | {"effects": effects}


def long_runs(dice: Random) -> Plain:
    """Ten minutes of what comes to rest, swings or rattles."""
    plain = row(dice, most=3, walls=0.6)
    effects = one_slope([any_effect(dice, plain) for _ in range(dice.randint(1, 2))])
    return plain | {"effects": effects, "until": dice.choice([60, 600])}


def scales(dice: Random) -> Plain:
    """Atoms and planets: lengths, masses and times far from a metre, a kilogram, a second."""
    plain = dice.choice([chain, rest_on_slope, touching_springs, releases, collisions])(dice)
    return scaled(plain, *(2.0 ** dice.choice([-30, -20, -10, 0, 10, 20]) for _ in range(3)))


def hertz(dice: Random) -> Plain:
    """Spheres: pairs, rows, overlaps, with and without effects."""
    plain = row(dice, least=2, laws=("hertz",), rooms=(0.0, 0.01, 0.1))
    if "pairs" in plain["contact"] and dice.random() < 0.5:
        del plain["contact"]["pairs"]
    if dice.random() < 0.5:
        plain["effects"] = [any_effect(dice, plain)]
    return overlapped(dice, plain) if dice.random() < 0.2 else plain


def friction(dice: Random) -> Plain:
    """Dry friction on rows that are pushed, pulled and hit."""
    plain = row(dice)
    effects = [
        a_friction(dice, plain),
        any_effect(dice, plain, ("incline", "push", "spring", "drag")),
    ]
    return plain | {"effects": effects}


def releases(dice: Random) -> Plain:
    """Energy set free between carts that touch, do not touch, or touch by then."""
    plain = row(dice, least=2, rooms=(0.0, 0.0, 0.05))
    between = pair(dice, plain, walls=False)
    at = dice.choice([0, 0, 0.1, 0.5])
    effects = [{"release": {"between": between, "energy": dice.choice([0.1, 1]), "at": at}}]
    if dice.random() < 0.5:
        effects.append(any_effect(dice, plain))
    return plain | {"effects": effects}


def overlaps(dice: Random) -> Plain:
    """Bumpers that overlap when the run begins."""
    plain = overlapped(dice, row(dice, least=2, laws=FINITE))
    if dice.random() < 0.5:
        plain["effects"] = [any_effect(dice, plain)]
    return plain


def instant_rows(dice: Random) -> Plain:
    """Impacts without a duration, between walls and in touch: collapse is near."""
    plain = row(dice, least=2, laws=("instant",), rooms=(0.0, 0.0, 0.1), walls=0.5)
    if dice.random() < 0.6:
        plain["effects"] = [
            any_effect(dice, plain, ("incline", "push", "friction", "drag", "spring"))
        ]
    return plain


def collisions(dice: Random) -> Plain:
    """Plain collisions with masses from a grain to a train, all laws, no effects."""
    return row(dice, least=2, masses=(1e-4, 1e4), walls=0.5, until=dice.choice([2, 10]))


def bouncing(dice: Random) -> Plain:
    """Carts that fall against a wall or each other again and again: rattles that end."""
    plain = row(dice, most=3, walls=0.9, laws=(*FINITE, "instant"))
    return plain | {
        "effects": [{"incline": {"angle": f"{dice.choice([3, -3, 10, -10])} deg"}}],
        "until": dice.choice([3, 10]),
    }


KINDS: dict[str, Callable[[Random], Plain]] = {
    "rest on slopes": rest_on_slope,
    "chains": chain,
    "pushes at edges": pushes_at_edges,
    "dead bumpers": dead_bumpers,
    "touching springs": touching_springs,
    "magnets": magnets,
    "springs": springs,
    "long runs": long_runs,
    "scales": scales,
    "hertz": hertz,
    "friction": friction,
    "releases": releases,
    "overlaps": overlaps,
    "instant rows": instant_rows,
    "collisions": collisions,
    "bouncing": bouncing,
    "classroom": classroom,
}


def scene_of(kind: str, seed: int) -> Plain:
    """Scene number `seed` of a kind, the same for ever."""
    return KINDS[kind](Random(f"{kind} {seed}"))
