"""What a page is answered, with every sentence in it as English text."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sim.scene.said import from_wire


def heard(value: Any) -> Any:
    """The same; it came over the wire as templates with their values."""
    if isinstance(value, Mapping):
        if "code" in value and "values" in value:
            return from_wire(value)
        return {key: heard(one) for key, one in value.items()}
    return [heard(one) for one in value] if isinstance(value, list) else value
