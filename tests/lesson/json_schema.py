"""The few words of JSON Schema that our schemas use."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any


def faults(value: Any, rule: Mapping[str, Any], at: str = "") -> Iterator[str]:
    """What JSON Schema says against `value`: the few words of it that ours use."""
    kinds = {"string": str, "object": dict, "array": list, "boolean": bool, "null": type(None)}
    wanted = rule.get("type", [])
    names = [wanted] if isinstance(wanted, str) else wanted
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    fits = [number if n in ("number", "integer") else isinstance(value, kinds[n]) for n in names]
    if names and not any(fits):
        yield f"{at}: not {wanted}"
        return
    if "anyOf" in rule and all(list(faults(value, one, at)) for one in rule["anyOf"]):
        yield f"{at}: fits none"
    if "enum" in rule and value not in rule["enum"]:
        yield f"{at}: {value}"
    if "const" in rule and value != rule["const"]:
        yield f"{at}: {value}"
    if isinstance(value, str) and not re.search(rule.get("pattern", ""), value):
        yield f"{at}: pattern"
    if isinstance(value, str) and len(value) < rule.get("minLength", 0):
        yield f"{at}: too short"
    if isinstance(value, dict):
        yield from (
            f"{at}: {name} is missing" for name in rule.get("required", []) if name not in value
        )
        for name, part in value.items():
            if name in rule.get("properties", {}):
                yield from faults(part, rule["properties"][name], f"{at}.{name}")
                continue
            fit = [r for p, r in rule.get("patternProperties", {}).items() if re.search(p, name)]
            for one in fit:
                yield from faults(part, one, f"{at}.{name}")
            if fit:
                continue
            others = rule.get("additionalProperties", True)
            if others is False:
                yield f"{at}: {name} is unknown"
            elif others is not True:
                yield from faults(part, others, f"{at}.{name}")
    if number and not (
        rule.get("minimum", value) <= value <= rule.get("maximum", value)
        and rule.get("exclusiveMinimum", value - 1) < value
    ):
        yield f"{at}: {value} is out of range"
    if isinstance(value, list):
        if not rule.get("minItems", 0) <= len(value) <= rule.get("maxItems", len(value)):
            yield f"{at}: {len(value)} items"
        for k, part in enumerate(value):
            yield from faults(part, rule.get("items", {}), f"{at}[{k}]")
