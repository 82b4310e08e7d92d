"""Rows of carts for the adversary: plain numbers and extreme ones, apart, in touch, overlapped."""

from __future__ import annotations

import itertools
from random import Random
from typing import Any

Plain = dict[str, Any]

LAWS = ("bumper", "paper", "push-only", "push-only-uncorrected", "instant", "velcro")
FINITE = ("bumper", "paper", "push-only", "push-only-uncorrected")


def rounded(value: float) -> float:
    """Three figures: a scene that a person can read."""
    return float(f"{value:.3g}")


def log_uniform(dice: Random, low: float, high: float) -> float:
    """Every power of ten is as likely."""
    return rounded(low * (high / low) ** dice.random())


def contact(dice: Random, laws: tuple[str, ...] = LAWS, **given: Any) -> Plain:
    """One law with its numbers; `given` are kept."""
    law = given.pop("law", None) or dice.choice(laws)
    found: Plain = {"law": law}
    if law != "velcro":
        e = dice.choice([0, 0, 1, 1, 0.5, 0.8, 0.3, 0.05, rounded(dice.random())])
        found["restitution"] = max(e, 0.05) if law.startswith("push-only") else e
    if law not in ("instant", "velcro"):
        found["stiffness"] = log_uniform(dice, 10, 1e6)
    return found | {key: value for key, value in given.items() if key in found}


def row(
    dice: Random,
    *,
    most: int = 5,
    least: int = 1,
    rooms: tuple[float, ...] = (0.0, 0.0, 0.01, 0.1, 0.3),
    speeds: tuple[float, ...] = (0.0, 0.0, 1.0, -1.0, 0.5, -0.3),
    masses: tuple[float, float] = (0.2, 5.0),
    walls: float = 0.4,
    laws: tuple[str, ...] = LAWS,
    until: float = 3.0,
) -> Plain:
    """Carts with walls at some ends, laws of which one pair may have its own."""
    count = dice.randint(least, most)
    carts: Plain = {}
    edge = 0.0 if dice.random() < 0.5 else dice.choice([0.1, 0.25])
    for k in range(count):
        mass = 1.0 if dice.random() < 0.4 else log_uniform(dice, *masses)
        carts["ABCDEFGH"[k]] = {
            "mass": mass,
            "position": round(edge + 0.1, 6),
            "velocity": dice.choice([*speeds, rounded(dice.uniform(-1, 1))]),
        }
        edge += 0.2 + dice.choice([*rooms, rounded(dice.uniform(0, 0.3))])
    plain: Plain = {
        "carts": carts,
        "track": {
            "left": "wall" if dice.random() < walls else "open",
            "right": "wall" if dice.random() < walls else "open",
            "length": round(edge + dice.choice([0.0, 0.05, 0.3]), 6),
        },
        "contact": contact(dice, laws),
        "until": until,
    }
    names = bodies(plain)
    if len(names) > 1 and dice.random() < 0.4:
        k = dice.randrange(len(names) - 1)
        plain["contact"]["pairs"] = {f"{names[k]}-{names[k + 1]}": contact(dice, laws)}
    return plain


def bodies(plain: Plain) -> list[str]:
    """Walls and carts from left to right."""
    track = plain.get("track", {})
    return [
        *(["left"] if track.get("left") == "wall" else []),
        *plain["carts"],
        *(["right"] if track.get("right") == "wall" else []),
    ]


def room_of(plain: Plain, left: str, right: str) -> float:
    """m. Edge to edge between two neighbours."""
    carts = plain["carts"]
    a = carts[left]["position"] + 0.1 if left in carts else 0.0
    b = carts[right]["position"] - 0.1 if right in carts else plain["track"]["length"]
    return float(b - a)


def pair(dice: Random, plain: Plain, *, walls: bool = True, room: float = -1.0) -> list[str] | None:
    """Two neighbours at least `room` m apart; None where there are none."""
    names = bodies(plain)
    found = [
        [a, b]
        for a, b in itertools.pairwise(names)
        if (walls or {a, b} <= set(plain["carts"])) and room_of(plain, a, b) >= room
    ]
    return dice.choice(found) if found else None


def overlapped(dice: Random, plain: Plain) -> Plain:
    """Some carts are moved into their left neighbours."""
    names = list(plain["carts"])
    for k in range(1, len(names)):
        if dice.random() < 0.6:
            room = room_of(plain, names[k - 1], names[k])
            for name in names[k:]:
                cart = plain["carts"][name]
                deeper = dice.choice([0.0001, 0.01, 0.02])
                cart["position"] = round(cart["position"] - room - deeper, 6)
    return plain | {"start": {"overlap": True}}
