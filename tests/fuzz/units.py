"""A scene in other units, powers of 2: the same run to the last bit."""

from __future__ import annotations

from decimal import Decimal, localcontext
from typing import Any

from tests.fuzz.rows import Plain


def scaled(plain: Plain, m: float, length: float, s: float) -> Plain:
    """The scene in other units, powers of 2: every decimal is exact. Hertz left out."""

    def contact_scaled(c: Plain) -> Plain:
        found = dict(c)
        if "stiffness" in c:
            found["stiffness"] = times(c["stiffness"], m / s**2)
        if "pairs" in c:
            found["pairs"] = {name: contact_scaled(own) for name, own in c["pairs"].items()}
        return found

    units = {
        "stiffness": m / s**2,
        "length": length,
        "damping": m / s,
        "energy": m * length**2 / s**2,
        "force": m * length / s**2,
        "at": s,
        "from": s,
        "until": s,
        "linear": m / s,
        "quadratic": m / length,
    }

    def effect_scaled(body: Plain) -> Plain:
        own = units | {"strength": units["force"] * length ** body.get("power", 3)}
        return {k: times(v, own[k]) if k in own else v for k, v in body.items()}

    effects = [
        {kind: effect_scaled(body) for kind, body in entry.items()}
        for entry in plain.get("effects", [])
    ]
    carts = {
        name: {
            "mass": times(cart["mass"], m),
            "position": times(cart["position"], length),
            "velocity": times(cart["velocity"], length / s),
            "length": times(cart.get("length", 0.2), length),
        }
        for name, cart in plain["carts"].items()
    }
    return plain | {
        "carts": carts,
        "track": plain["track"] | {"length": times(plain["track"]["length"], length)},
        "contact": contact_scaled(plain["contact"]),
        "effects": effects,
        "gravity": times(plain.get("gravity", 9.81), length / s**2),
        "until": times(plain["until"], s),
    }


def times(value: Any, power_of_two: float) -> Any:
    """The decimal, multiplied exactly: a float where that has the same decimals, else a text."""
    with localcontext() as exact:
        exact.prec = 400
        product = Decimal(str(value)) * Decimal(power_of_two)
        return float(product) if Decimal(repr(float(product))) == product else f"{product:e}"
