"""A scene of the search as an author would write it: it can be pasted into a file and run."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def as_yaml(scene: Mapping[str, Any], title: str = "") -> str:
    """YAML; the law's text stands in it, so that nothing else is needed."""
    lines = [f"title: {_quoted(title)}"] if title else []
    lines.append("carts:")
    for name, cart in scene["carts"].items():
        lines.append(f"  {name}: {_flow(cart)}")
    lines.append(f"contact: {_flow(scene['contact'])}")
    lines.append(f"until: {scene['until']:g}")
    lines.append("laws:")
    for file, text in scene["laws"].items():
        rows = text.expandtabs(4).strip("\n").splitlines()
        first = next((row for row in rows if row.strip()), "")
        deep = "2" if first.startswith(" ") else ""  # else its first line would say how far in
        lines.append(f"  {file}: |{deep}")
        for line in rows:
            lines.append(f"    {line}".rstrip())
    return "\n".join(lines) + "\n"


def _flow(table: Mapping[str, Any]) -> str:
    rows = (f"{key}: {_value(value)}" for key, value in table.items())
    return "{" + ", ".join(rows) + "}"


def _value(value: Any) -> str:
    return f"{value:.12g}" if isinstance(value, (int, float)) else str(value)


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'
