"""Questions as students number them, from 1: what a report calls those of one student."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any


def numbering(form: Mapping[str, Any]) -> Callable[[Sequence[str]], list[str]]:
    """Ids of questions as numbers. Without a key a form does not know its order: then as they are,
    and so is the id of a question that it does not have."""
    known = {item["id"]: f"{k}" for k, item in enumerate(form["items"], 1) if form["has_key"]}
    return lambda items: [known.get(name, name) for name in items]
