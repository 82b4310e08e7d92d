"""Scenes that a teacher or a student would write: two to five carts, and round numbers throughout.

The other kinds aim at what an engine has to decide; this one asks what a class would ask, and how
often that takes long or ends wrong.
"""

from __future__ import annotations

import itertools
from random import Random

from tests.fuzz.rows import Plain

LAWS = ("instant", "instant", "bumper", "bumper", "bumper", "hertz", "paper", "push-only", "velcro")
STIFFNESS = {"hertz": (1_000, 10_000)}
ANGLES = (1, 2, 3, 5, 10, -1, -2, -3, -5, -10)


def classroom(dice: Random) -> Plain:
    """One law for all, a slope, friction or air, now and then a spring, a push, magnets."""
    magnets = dice.random() < 0.15
    carts: Plain = {}
    edge = dice.choice([0.0, 0.1, 0.2, 0.5])
    for name in "ABCDE"[: dice.choice([2, 2, 2, 3, 3, 4, 5])]:
        carts[name] = {
            "mass": dice.choice([0.25, 0.5, 0.5, 1.0, 1.0, 2.0]),
            "position": round(edge + 0.1, 6),
            "velocity": dice.choice([0.0, 0.0, 0.0, 0.2, 0.5, -0.2, -0.5, 1.0, -1.0]),
        }
        edge += 0.2 + dice.choice([0.1, 0.2, 0.5] if magnets else [0.0, 0.0, 0.1, 0.2, 0.5])
    between = list(itertools.pairwise(carts))
    effects = _acting(dice, carts, between)
    if magnets:
        effects += [_magnets(dice, a, b) for a, b in between]
    return {
        "carts": carts,
        "track": {
            "left": dice.choice(["wall", "wall", "open"]),
            "right": dice.choice(["wall", "wall", "open"]),
            "length": round(edge + dice.choice([0.0, 0.2, 0.5]), 6),
        },
        "contact": _contact(dice),
        "effects": effects,
        "until": dice.choice([10, 20, 30, 60]),
    }


def _contact(dice: Random) -> Plain:
    law = dice.choice(LAWS)
    found: Plain = {"law": law}
    if law != "velcro":
        e = dice.choice([0, 0.1, 0.2, 0.3, 0.5, 0.8, 0.9, 0.95, 1])
        found["restitution"] = max(e, 0.1) if law == "push-only" else e
    if law not in ("instant", "velcro"):
        found["stiffness"] = dice.choice(STIFFNESS.get(law, (100, 200, 400, 400, 1000, 2000)))
    return found


def _acting(dice: Random, carts: Plain, between: list[tuple[str, str]]) -> list[Plain]:
    effects: list[Plain] = []
    if dice.random() < 0.5:
        effects.append({"incline": {"angle": f"{dice.choice(ANGLES)} deg"}})
    resists = dice.random()
    if resists < 0.35:
        effects.append({"friction": {"coefficient": dice.choice([0.01, 0.02, 0.05, 0.1, 0.2])}})
    elif resists < 0.5:
        law = dice.choice(["linear", "quadratic"])
        effects.append({"drag": {law: dice.choice([0.05, 0.1, 0.5])}})
    if dice.random() < 0.2:
        spring = {
            "between": list(dice.choice(between)),
            "stiffness": dice.choice([2, 5, 10, 20, 50]),
            "length": dice.choice([0.1, 0.2, 0.3]),
            "damping": dice.choice([0, 0, 0.1, 0.5]),
        }
        effects.append({"spring": spring})
    if dice.random() < 0.15:
        force, until = dice.choice([0.5, 1, 2, -1]), dice.choice([0.5, 1, 2])
        push = {"cart": dice.choice(list(carts)), "force": force, "from": 0, "until": until}
        effects.append({"push": push})
    return effects


def _magnets(dice: Random, left: str, right: str) -> Plain:
    strength, power = dice.choice([1e-5, 1e-4, 1e-3]), dice.choice([2, 4])
    return {"magnets": {"between": [left, right], "strength": strength, "power": power}}
