"""The keys that a built site gives to its page for teachers."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any


def keys_of(site: Path) -> list[dict[str, Any]]:
    """The keys that a built site brings along."""
    script = (site / "assets" / "carts" / "class-keys.js").read_text(encoding="utf-8")
    return [json.loads(text) for text in in_full(brought(script)["__cartsKeys"])]


def in_full(given: list[str | list[Any]]) -> list[str]:
    """As `sim/web/src/class/brought-along.js` puts them together."""
    return [
        text if isinstance(text, str) else with_texts(given[text[0]], iter(text[1:]))
        for text in given
    ]


def with_texts(like: Any, own: Iterator[Any]) -> str:
    def string(same: re.Match[str]) -> str:
        return json.dumps(text) if isinstance(text := next(own), str) else same[0]

    return re.sub(r'"(?:[^"\\]|\\.)*"', string, like)


def brought(script: str) -> dict[str, Any]:
    """What the script gives to its page, by name."""
    lines = (line.removeprefix("self.").rstrip(";").split(" = ", 1) for line in script.splitlines())
    return {name: json.loads(value) for name, value in lines}
