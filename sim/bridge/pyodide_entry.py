"""The only file that knows the browser: JSON text in, JSON text and a Float64Array out."""

from __future__ import annotations

import json
from typing import Any

from sim.bridge.alive import listen
from sim.bridge.protocol import answer as plain_answer

__all__ = ["answer", "listen"]


def answer(request_json: str) -> Any:
    """Answer one request as a JavaScript array [header as JSON text, Float64Array]."""
    from js import Array, Float64Array

    header, numbers = plain_answer(json.loads(request_json))
    values = Float64Array.new(len(numbers))
    if numbers:
        values.assign(memoryview(numbers))
    return Array.of(json.dumps(header, allow_nan=False), values)
