"""Effects for the adversary's scenes."""

from __future__ import annotations

from random import Random
from typing import Any

from tests.fuzz.rows import Plain, log_uniform, pair, rounded


def a_friction(dice: Random, plain: Plain) -> Plain:
    low = dice.choice([0, 0.02, 0.1, 0.3, 0.05])
    body: Plain = {"coefficient": low}
    if dice.random() < 0.5:
        body["static"] = rounded(low * 1.5)
    if dice.random() < 0.4:
        body["carts"] = [dice.choice(list(plain["carts"]))]
    return {"friction": body}


def a_push(dice: Random, plain: Plain) -> Plain:
    body: Plain = {
        "cart": dice.choice(list(plain["carts"])),
        "force": dice.choice([1, -1, 0.1, -5, rounded(dice.uniform(-3, 3)) or 1]),
    }
    if dice.random() < 0.8:
        body["from"] = dice.choice([0, 0.1, 0.5])
        body["until"] = body["from"] + dice.choice([0.1, 0.3, 1])
    return {"push": body}


def a_spring(dice: Random, plain: Plain) -> Plain:
    return {
        "spring": {
            "between": pair(dice, plain),
            "stiffness": log_uniform(dice, 1, 1000),
            "length": dice.choice([0, 0, 0.05, 0.1, 0.3]),
            "damping": dice.choice([0, 0, 0.3, 8]),
        }
    }


def any_effect(dice: Random, plain: Plain, kinds: tuple[str, ...] = ()) -> Plain:
    kind = dice.choice(kinds or ("friction", "incline", "push", "spring", "drag"))
    if kind == "spring" and pair(dice, plain):
        return a_spring(dice, plain)
    if kind == "friction":
        return a_friction(dice, plain)
    if kind == "push":
        return a_push(dice, plain)
    if kind == "drag":
        body: dict[str, Any] = {dice.choice(["linear", "quadratic"]): dice.choice([0.05, 0.5, 3])}
        return {"drag": body}
    return {"incline": {"angle": f"{dice.choice([2, -2, 5, -10])} deg"}}
