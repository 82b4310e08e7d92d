"""A file of answers in which all is right, to be damaged."""

from __future__ import annotations

from typing import Any

TIME = "2026-11-21T08:00:00.000Z"
ITEM = {"id": "why", "hash": "0123456789ab", "type": "long", "value": "because", "first": TIME,
        "last": TIME, "tries": 1}  # fmt: skip
GOOD: dict[str, Any] = {
    "format": 1, "kind": "newtons-carts-answers", "site": "tests", "lesson": "kinds",
    "lessonHash": "0123456789ab", "student": "BLUE-FOX-27", "form": "worksheet", "created": TIME,
    "saved": TIME, "page": "worksheets/kinds", "items": [ITEM],
}  # fmt: skip
