"""Random scenes that a certificate may be asked for: pairs and rows, all laws, constant forces.

`touching` are rows of which three and more push each other at once: cradles, trains that are hit,
carts between soft walls. `swinging` have springs and linear drag, `letting_go` exploders.
"""

from __future__ import annotations

from random import Random
from typing import Any

from tests.one_slope import one_slope

LAWS = ("bumper", "paper", "push-only", "push-only-uncorrected", "instant", "velcro")
SOFT = LAWS[:4]


def plain(seed: int) -> dict[str, Any]:
    """One scene as an author would write it; few digits, so that carts may meet at one instant."""
    dice = Random(seed)
    count = dice.choice([1, 2, 2, 2, 2, 3, 4])
    x, carts = 0.0, {}
    for k in range(count):
        x = round(x + 0.2 + dice.choice([0.0, 0.05, dice.uniform(0.05, 0.8)]), 3)
        carts["ABCD"[k]] = {
            "mass": round(10 ** dice.uniform(-1, 1), 3),
            "position": x,
            "velocity": dice.choice([0, 0.5, -0.5, round(dice.uniform(-1.5, 1.5), 3)]),
        }
    right = dice.random() < 0.4
    track: dict[str, Any] = {"left": dice.choice(["open", "open", "wall"])}
    track |= {"right": "wall", "length": round(x + 0.1 + dice.uniform(0.1, 1), 3)} if right else {}
    scene = {
        "carts": carts,
        "track": track,
        "contact": _contact(dice),
        "until": dice.choice([1, 3]),
    }
    if count > 1 and dice.random() < 0.2:
        scene["contact"]["pairs"] = {"A-B": _contact(dice)}
    if dice.random() < 0.4:
        listed = [_effect(dice, list(carts)) for _ in range(dice.choice([1, 1, 2]))]
        scene["effects"] = one_slope(listed)
    return scene


def touching(seed: int) -> dict[str, Any]:
    """A row of 3 to 6 carts, some of which touch from the start; the last may come from outside."""
    dice = Random(f"row {seed}")
    count = dice.choice([3, 3, 3, 4, 5, 6])
    alike, x, carts = dice.random() < 0.3, 0.2, {}
    hit = dice.choice([0.5, 1, round(dice.uniform(0.2, 1.5), 2)])
    for k in range(count):
        x = round(x + 0.2 + (dice.choice([0, 0, 0.001, round(dice.uniform(0, 0.2), 3)])), 3)
        came = k == 0 or (k == count - 1 and dice.random() < 0.4)
        carts["ABCDEF"[k]] = {
            "mass": 1 if alike else round(10 ** dice.uniform(-0.7, 0.7), 2),
            "position": x,
            "velocity": (hit if k == 0 else -0.7) if came else 0,
        }
    walls = dice.choice(["open", "open", "wall"])
    track = {"right": walls, "length": round(x + 0.1 + dice.choice([0, dice.uniform(0, 0.3)]), 3)}
    contact = _contact(dice, SOFT)
    scene = {"carts": carts, "track": track, "contact": contact, "until": dice.choice([0.5, 1, 2])}
    if dice.random() < 0.3:
        contact["pairs"] = {"A-B": _contact(dice, SOFT), "B-C": _contact(dice, LAWS)}
    if dice.random() < 0.3:
        scene["effects"] = [_effect(dice, list(carts))]
    return scene


def swinging(seed: int) -> dict[str, Any]:
    """One to four carts with springs between them or to a wall, in air that may drag."""
    dice = Random(f"springs {seed}")
    count = dice.choice([1, 2, 2, 3, 4])
    x, carts = 0.3, {}
    for k in range(count):
        x = round(x + 0.2 + dice.uniform(0.02, 0.4), 3)
        speed = dice.choice([0, round(dice.uniform(-0.8, 0.8), 2)])
        mass = round(10 ** dice.uniform(-0.7, 0.7), 2)
        carts["ABCD"[k]] = {"mass": mass, "position": x, "velocity": speed}
    track = {"left": "wall", "right": "wall", "length": round(x + 0.1 + dice.uniform(0.05, 0.5), 3)}
    row = ["left", *carts, "right"]
    effects: list[dict[str, Any]] = []
    for k in dice.sample(range(count + 1), dice.choice([1, 1, 2]) if count > 1 else 1):
        spring = {"between": row[k : k + 2], "stiffness": round(10 ** dice.uniform(0, 2), 2)}
        spring |= {"length": round(dice.uniform(0, 0.6), 2)}
        effects.append({"spring": spring | {"damping": dice.choice([0, 0, 0.2])}})
    if dice.random() < 0.4:
        effects.append({"drag": {"linear": round(dice.uniform(0.05, 1), 2)}})
    elif dice.random() < 0.5:
        effects.append(_effect(dice, list(carts)))
    contact, until = _contact(dice), dice.choice([0.5, 1, 2])
    return {"carts": carts, "track": track, "contact": contact, "until": until, "effects": effects}


def letting_go(seed: int) -> dict[str, Any]:
    """Two to four carts; one or two exploders part those that touch, or find them apart."""
    dice = Random(f"release {seed}")
    count = dice.choice([2, 2, 3, 4])
    x, carts = 0.3, {}
    alike = dice.choice([0, 0, round(dice.uniform(-0.5, 0.5), 2)])
    for k in range(count):
        x = round(x + 0.2 + dice.choice([0, 0, 0, round(dice.uniform(0.02, 0.3), 3)]), 3)
        speed = alike if dice.random() < 0.8 else round(dice.uniform(-0.8, 0.8), 2)
        mass = round(10 ** dice.uniform(-0.7, 0.7), 2)
        carts["ABCD"[k]] = {"mass": mass, "position": x, "velocity": speed}
    track = {
        "left": dice.choice(["open", "wall"]),
        "right": dice.choice(["open", "wall"]),
        "length": round(x + 0.1 + dice.choice([0, dice.uniform(0.05, 0.5)]), 3),
    }
    names = list(carts)
    effects: list[dict[str, Any]] = []
    for k in dice.sample(range(count - 1), dice.choice([1, 1, min(2, count - 1)])):
        one = {"between": names[k : k + 2], "energy": round(10 ** dice.uniform(-2.5, -0.3), 4)}
        one["at"] = dice.choice([0, 0.25, round(dice.uniform(0, 1), 2)])
        if dice.random() < 0.5:
            one["stiffness"] = round(10 ** dice.uniform(1, 3), 1)
        effects.append({"release": one})
    if dice.random() < 0.4:
        effects.append(_effect(dice, names))
    contact, until = _contact(dice), dice.choice([0.5, 1, 2])
    return {"carts": carts, "track": track, "contact": contact, "until": until, "effects": effects}


def letting_go_from_rest(seed: int) -> dict[str, Any]:
    """The same on a rough track, where all stand until a spring is let go."""
    made, dice = letting_go(seed), Random(f"rough {seed}")
    for cart in made["carts"].values():
        cart["velocity"] = 0
    releases = [one for one in made["effects"] if "release" in one]
    rough = {"friction": {"coefficient": round(10 ** dice.uniform(-2, -0.5), 4)}}
    return made | {"effects": [*releases, rough]}


def _contact(dice: Random, laws: tuple[str, ...] = LAWS) -> dict[str, Any]:
    law = dice.choice(laws)
    found: dict[str, Any] = {"law": law}
    if law != "velcro":
        least = 0.02 if law.startswith("push") else 0
        found["restitution"] = max(least, dice.choice([0, 0.5, 1, round(dice.uniform(0, 1), 3)]))
    if law not in ("instant", "velcro"):
        found["stiffness"] = round(10 ** dice.uniform(2, 4.5))
    return found


def _effect(dice: Random, names: list[str]) -> dict[str, Any]:
    kind = dice.choice(["friction", "incline", "push"])
    if kind == "friction":
        low = round(dice.uniform(0, 0.05), 4)
        more = (
            {"static": round(low * dice.uniform(1, 2) + 0.0001, 4)} if dice.random() < 0.3 else {}
        )
        return {"friction": {"coefficient": low, **more}}
    if kind == "incline":
        return {"incline": {"angle": round(dice.uniform(-0.05, 0.05), 4)}}
    begin = round(dice.uniform(0, 1), 2)
    push = {"cart": dice.choice(names), "force": round(dice.uniform(-1, 1), 2), "from": begin}
    return {"push": push | {"until": round(begin + dice.uniform(0.1, 1), 2)}}
