"""JSON Schemas, made from the tables of keys: for editors that complete and check as one types."""

from __future__ import annotations

from typing import Any

from sim.lesson import answer_file, key_file
from sim.lesson.bank import BANK_KEYS
from sim.lesson.form import FORM_KEYS
from sim.lesson.keys import Key
from sim.lesson.opening import FORMS
from sim.lesson.question import COMMON_KEYS
from sim.lesson.read import KINDS

_DIALECT = "https://json-schema.org/draft/2020-12/schema"
_TIME = {"type": ["string", "null"]}
_TEXT = {"type": "string"}


def question_schema() -> dict[str, Any]:
    """A question: one of the kinds, each with the common keys and its own."""
    return {"anyOf": [_table((*COMMON_KEYS, *kind.KEYS), name) for name, kind in KINDS.items()]}


def bank_schema() -> dict[str, Any]:
    """A file in worksheets/banks/."""
    table = _table(BANK_KEYS)
    table["properties"]["items"] = {"type": "array", "minItems": 1, "items": question_schema()}
    return {"$schema": _DIALECT, "title": "A bank of questions", **table}


def form_schema() -> dict[str, Any]:
    """The body of a quiz block."""
    return {"$schema": _DIALECT, "title": "A form", **_table(FORM_KEYS)}


def answers_schema() -> dict[str, Any]:
    """The file of a student's answers."""
    item = {
        "type": "object",
        "required": ["id", "hash", "type", "value", "first", "last", "tries"],
        "properties": {
            "id": _TEXT, "hash": {"type": "string", "pattern": "^([0-9a-f]{12})?$"}, "type": _TEXT,
            "value": {}, "first": _TIME, "last": _TIME, "tries": {"type": "integer", "minimum": 0},
            "unit": _TEXT, "sure": _TEXT, "said": _TEXT, "asked": _TEXT, "locked": _TEXT,
            "again": _TEXT, "own": {"type": "number"}, "set": {"type": "object"},
            "right": {"type": "integer", "minimum": 0}, "before": {"type": "object"},
        },
    }  # fmt: skip
    properties = {
        "format": {"const": answer_file.FORMAT}, "kind": {"const": answer_file.KIND}, "site": _TEXT,
        "lesson": _TEXT, "lessonHash": _TEXT, "student": _TEXT, "form": {"enum": list(FORMS)},
        "created": _TEXT, "saved": _TEXT, "page": _TEXT, "handed": _TEXT, "code": _TEXT,
        "items": {"type": "array", "maxItems": answer_file.MOST_ITEMS, "items": item},
    }  # fmt: skip
    optional = ("page", "handed", "code")
    required = [name for name in properties if name not in optional]
    return {
        "$schema": _DIALECT,
        "title": "A student's answers",
        "type": "object",
        "required": required,
        "properties": properties,
    }


def key_schema() -> dict[str, Any]:
    """The teacher's key file."""
    part = {
        "type": "object",
        "required": ["form", "hash", "options", "items"],
        "properties": {"form": {"enum": list(FORMS)}, "hash": _TEXT, "options": {"type": "array"},
                       "items": {"type": "array", "items": {"type": "object"}}},
    }  # fmt: skip
    properties = {
        "format": {"const": key_file.FORMAT}, "kind": {"const": key_file.KIND}, "site": _TEXT,
        "lesson": _TEXT, "forms": {"type": "array", "items": part},
    }  # fmt: skip
    return {
        "$schema": _DIALECT,
        "title": "The key of a lesson",
        "type": "object",
        "required": list(properties),
        "properties": properties | {"title": _TEXT},
    }


def _table(keys: tuple[Key, ...], kind: str = "") -> dict[str, Any]:
    properties: dict[str, Any] = {
        key.name: {"description": f"{key.says}. Example: {key.example}", **key.schema}
        for key in keys
    }
    if kind:
        properties["type"] = {"const": kind}
    return {
        "type": "object",
        "properties": properties,
        "required": [key.name for key in keys if key.required],
        "additionalProperties": False,
    }
