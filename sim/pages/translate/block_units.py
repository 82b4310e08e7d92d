"""The units of YAML: blocks of a lesson, front matter, banks. Which values are text, schemas say.

`sim.scene.prose.MARK` in the tables of keys is the only place where that stands.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import Any

from sim.pages.teach.spans import names, values
from sim.pages.text.fence_scan import Block
from sim.pages.text.yaml.source import KeyPath
from sim.pages.translate.unit import Unit, is_prose
from sim.scene.prose import MARK, PROSE

Schema = Mapping[str, Any]

FRONT_MATTER: Schema = {"properties": {"title": PROSE, "description": PROSE}}


@cache
def schema_of(kind: str) -> Schema:
    """What is read in a block of this kind, in the front matter (top) and in a bank."""
    from sim.lesson.schema import bank_schema, form_schema, question_schema
    from sim.pages.law.block import READ as LAW
    from sim.pages.measured.block import READ as MEASURED
    from sim.pages.question.challenge import KEYS as CHALLENGE
    from sim.scene.schema import read_in_fence

    if kind == "top":
        return FRONT_MATTER
    if kind in ("question", "bank", "quiz"):
        made = {"question": question_schema, "bank": bank_schema, "quiz": form_schema}
        return made[kind]()
    own: dict[str, Schema] = {
        "scene": read_in_fence(),
        "challenge": {"properties": {key.name: key.schema for key in CHALLENGE}},
        "measured": MEASURED,
        "law": {"anyOf": [LAW, read_in_fence()]},
    }
    return own.get(kind, {})


def block_units(text: str, block: Block, kind: str) -> Iterator[Unit]:
    """The units of a block, in their order; none where it cannot be read."""
    schema = schema_of(kind)
    if not schema:
        return
    own = values(text, block)
    found = [(one, _at([schema], one.path)) for one in own]
    if "presets:" in block.body:  # the only keys that are read
        found += [(one, _named(_at([schema], one.path[:-1]))) for one in names(text, block)]
    read = [one for one, rules in found if any(MARK in rule for rule in rules)]
    identity = {one.path: one.value for one in own if one.path[-1:] == ("id",)}
    for one in sorted(read, key=lambda one: one.start):
        said = one.value.strip()
        if is_prose(said):
            name = identity.get((*one.path[:2], "id")) or identity.get(("id",), kind)
            where = " · ".join((name, *_shown(one.path)))
            item = identity.get((*one.path[:2], "id"), "") if kind == "bank" else ""
            yield Unit(one.start, one.end, said, "yaml", where, item=item)


def _shown(path: KeyPath) -> Iterator[str]:
    """A path as a translator reads it, entries counted from 1."""
    yield from (str(part + 1) if isinstance(part, int) else part for part in path)


def _at(schemas: Iterable[Schema], path: KeyPath) -> list[Schema]:
    """The schemas that speak of the value at a path."""
    found = list(_each(schemas))
    for part in path:
        found = list(_each(rule for one in found for rule in _below(one, part)))
    return found


def _each(schemas: Iterable[Schema]) -> Iterator[Schema]:
    for one in schemas:
        yield one
        yield from _each(one.get("anyOf", ()))


def _below(schema: Schema, part: str | int) -> Iterator[Schema]:
    if isinstance(part, int):
        yield from [schema["items"]] if "items" in schema else []
    elif part in schema.get("properties", {}):
        yield schema["properties"][part]
    else:
        patterns = schema.get("patternProperties", {}).items()
        yield from (rule for pattern, rule in patterns if re.search(pattern, part))


def _named(schemas: Iterable[Schema]) -> list[Schema]:
    return [one["propertyNames"] for one in schemas if "propertyNames" in one]
