"""A scene with left and right exchanged, to the last decimal."""

from __future__ import annotations

from decimal import Decimal
from typing import Any

from tests.fuzz.rows import Plain

TURNED = {"left": "right", "right": "left"}


def mirrored(plain: Plain) -> Plain:
    """The mirror image: places are told from the other end of the track."""
    track = plain["track"]
    length = Decimal(str(track["length"]))
    carts = {
        name: cart
        | {
            "position": str(length - Decimal(str(cart["position"]))),
            "velocity": _turned(cart["velocity"]),
        }
        for name, cart in plain["carts"].items()
    }
    contact = dict(plain["contact"])
    if "pairs" in contact:
        contact["pairs"] = {
            "-".join(TURNED.get(part, part) for part in reversed(name.split("-"))): pair
            for name, pair in contact["pairs"].items()
        }
    return plain | {
        "carts": carts,
        "track": track | {"left": track["right"], "right": track["left"]},
        "contact": contact,
        "effects": [
            {kind: _effect(kind, body)}
            for entry in plain.get("effects", [])
            for kind, body in entry.items()
        ],
    }


def _effect(kind: str, body: Plain) -> Plain:
    if kind == "incline":
        return body | {"angle": _turned(body["angle"])}
    if kind == "push":
        return body | {"force": _turned(body["force"])}
    if "between" in body:
        return body | {"between": [TURNED.get(name, name) for name in body["between"]]}
    return body


def _turned(value: Any) -> Any:
    """The other sign, of a number or of one with a unit."""
    if not isinstance(value, str):
        return -value
    return value[1:] if value.startswith("-") else f"-{value}"
