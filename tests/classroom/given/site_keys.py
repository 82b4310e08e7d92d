"""The keys that a built site gives to its page for teachers."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any


def keys_of(site: Path) -> list[dict[str, Any]]:
    """The keys that a built site brings along."""
    script = (site / "assets" / "carts" / "class-keys.js").read_text(encoding="utf-8")
    return [json.loads(text) for text in brought(script)["__cartsKeys"]]


def brought(script: str) -> dict[str, Any]:
    """What the script gives to its page, by name."""
    lines = (line.removeprefix("self.").rstrip(";").split(" = ", 1) for line in script.splitlines())
    return {name: json.loads(value) for name, value in lines}
