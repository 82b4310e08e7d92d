"""push: how large its force is, for the scale of a picture."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def largest(effect: Mapping[str, Any], header: Mapping[str, Any]) -> float:
    """N; it is constant."""
    return float(abs(effect["numbers"]["force"]))
