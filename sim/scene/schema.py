"""The JSON Schema of a scene, made from the table of fields: for editors that complete and check.

It knows every key, the range of plain numbers and the names of laws and effects. What hangs on
several keys at once (a wall without a track's length, carts in each other) only `read_scene` says.
"""

from __future__ import annotations

from typing import Any

from sim.scene.effects import EffectKind, kinds
from sim.scene.fence.predict import READ as READ_IN_PREDICT
from sim.scene.fields import (
    CART,
    GRAVITY,
    HERTZ_STIFFNESS,
    RESTITUTION,
    SKINS,
    STIFFNESS,
    TRACK_LENGTH,
    UNTIL,
    Field,
)
from sim.scene.laws import FILE, WRITTEN, laws
from sim.scene.prose import MARK, NAMED
from sim.scene.quantity import exact
from sim.scene.track import WHAT

DIALECT = "https://json-schema.org/draft/2020-12/schema"
NAME = "^[A-Za-z][A-Za-z0-9_-]{0,15}$"
NUMBER = r"^\s*[+−-]?(\d|\.\d)"
"""A text with a unit begins with a number."""

SIDES = {"enum": ["open", "wall"]}
IS = {"enum": list(WHAT), "description": "what stands there, where that side is a wall"}
PAIR = {"type": "array", "minItems": 2, "maxItems": 2, "items": {"type": "string"}}
CARTS = {"type": "array", "minItems": 1, "items": {"type": "string"}}
TITLE = {"type": "string", MARK: True}
ACTIVE = {"type": "boolean", "description": "false: described, so that a switch can turn it on"}


def scene_schema() -> dict[str, Any]:
    """A scene file."""
    overlap = {"type": "boolean", "description": "true: carts may overlap at the start"}
    effects = {"type": "array", "items": {"anyOf": [_effect(k) for k in kinds().values()]}}
    properties = {
        "title": TITLE,
        "carts": {
            "type": "object",
            "minProperties": 1,
            "patternProperties": {NAME: _table(*CART, skin={"enum": list(SKINS)})},
            "additionalProperties": False,
        },
        "track": _table(TRACK_LENGTH, left=SIDES, right=SIDES, left_is=IS, right_is=IS),
        "contact": _contact(pairs={"type": "object", "additionalProperties": _contact()}),
        "effects": effects,
        "estimate": {"description": "sizes of what is left out"} | effects,
        "laws": {
            "type": "object",
            "description": "texts of laws in Python, by the name of their file",
            "additionalProperties": {"type": "string"},
        },
        "until": field_schema(UNTIL),
        "gravity": field_schema(GRAVITY),
        "start": _table(overlap=overlap),
    }
    return {
        "$schema": DIALECT,
        "title": "A scene",
        "type": "object",
        "required": ["carts"],
        "properties": properties,
        "additionalProperties": False,
    }


def read_in_fence() -> dict[str, Any]:
    """The keys of a scene block whose texts readers read, as a schema."""
    read = {"title": TITLE, "predict": READ_IN_PREDICT, "presets": NAMED}
    return {"type": "object", "properties": read}


def field_schema(field: Field) -> dict[str, Any]:
    """A number in SI, or a text with a unit."""
    plain: dict[str, Any] = {"type": "number"}
    if field.least is not None:
        plain["exclusiveMinimum" if field.above else "minimum"] = float(exact(field.least))
    if field.most is not None:
        plain["maximum"] = float(exact(field.most))
    units = ", ".join(field.dimension.units)
    says = f"{field.says}; {units or 'no unit'}; {field.allowed}"
    found: dict[str, Any] = {
        "description": says,
        "anyOf": [plain, {"type": "string", "pattern": NUMBER}],
        "examples": [field.dimension.example],
    }
    if field.default is not None:
        found["default"] = float(exact(field.default))
    return found


def _table(*fields: Field, **more: Any) -> dict[str, Any]:
    return {
        "type": "object",
        "properties": {field.key: field_schema(field) for field in fields} | more,
        "required": [f.key for f in fields if f.default is None and not f.optional],
        "additionalProperties": False,
    }


def _contact(**more: Any) -> dict[str, Any]:
    """Keys of a contact; a stiffness is that of the law, in its own unit."""
    either = [field_schema(field) for field in (STIFFNESS, HERTZ_STIFFNESS)]
    described = "; ".join(f"{name}: {law.says}" for name, law in laws().items())
    own = {"type": "string", "pattern": f"^{FILE.pattern}$"}
    law = {"anyOf": [{"enum": list(laws())}, own], "description": f"{described}; {WRITTEN.says}"}
    return _table(RESTITUTION, law=law, stiffness={"anyOf": either}, **more)


def _effect(kind: EffectKind) -> dict[str, Any]:
    """One entry of the list: the kind, and its table."""
    key = kind.needs or "carts"
    body = {"carts": CARTS, "cart": {"type": "string"}, "between": PAIR}[key]
    table = _table(*kind.fields, **{key: body}, active=ACTIVE)
    if kind.by:
        table["properties"]["by"] = {"type": "string", "default": kind.by}
    if kind.needs:
        table["required"].append(key)
    if kind.one_of:
        table["anyOf"] = [{"required": [name]} for name in kind.one_of]
    return {
        "type": "object",
        "description": kind.says,
        "properties": {kind.name: table},
        "required": [kind.name],
        "additionalProperties": False,
    }
